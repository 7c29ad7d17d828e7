"""Studies: what accuracy costs, where renderers stop being right, and whether the harness notices a defect."""
