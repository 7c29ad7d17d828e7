"""Bodies made fit for POV-Ray: its units, contacts, gaps, nesting and meshes."""
