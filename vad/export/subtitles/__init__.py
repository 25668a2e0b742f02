"""The teacher's sentences beside the film: `cues` gives them their times, `srt` and `vtt` write."""
