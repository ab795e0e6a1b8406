"""How surfaces reflect: glossy lobes, microfacet models and measured tables, in SH."""
