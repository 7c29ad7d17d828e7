"""Linear radiance images: reading, resampling onto world-space patches, and the one display transform."""
