"""Pictures of a scene: camera, shading through transfer, brute force, tone mapping, and how far pictures differ."""
