"""The report: figures and page."""
