"""A film as MP4: `mp4` writes the file, `planes` turns its colours, `atoms` changes its index."""
