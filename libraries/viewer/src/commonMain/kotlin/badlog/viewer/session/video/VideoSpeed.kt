package badlog.viewer.session.video

/** The playback speeds of a video; 1 is the recorded speed. */
val VIDEO_SPEEDS: List<Double> = listOf(0.25, 0.5, 1.0, 2.0, 4.0)
