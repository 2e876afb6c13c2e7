package badlog.plot.video

/**
 * What is remembered of the video beside a log.
 *
 * @property name the name of the video's file.
 * @property alignment where it lies beside the log; null where nobody has aligned it.
 */
public class VideoNote(public val name: String, public val alignment: VideoAlignment?) {
    /** It in one line, which [videoNoteOf] reads: `12.5 match.mp4`, and `- match.mp4` without an alignment. */
    public fun toText(): String = "${alignment?.startSeconds ?: NONE} $name"
}

/** What [VideoNote.toText] wrote as [text]; null for another text. */
public fun videoNoteOf(text: String): VideoNote? {
    val (start, name) = text.split(' ', limit = 2).takeIf { it.size == 2 } ?: return null
    if (start == NONE) return VideoNote(name, null)
    return start.toDoubleOrNull()?.takeIf(Double::isFinite)?.let { VideoNote(name, VideoAlignment(it)) }
}

private const val NONE = "-"
