"""Why a phenomenon is required, or not, in sentences with names and numbers: one function a phenomenon."""
