package badlog.viewer.session.video

/**
 * The stored facts about a video of a log.
 *
 * @property name the name of the video's file.
 * @property alignment the alignment with the log; null before the video is aligned.
 */
class VideoNote(val name: String, val alignment: VideoAlignment?) {
    /** Returns the note as one line, which [videoNoteOf] reads: `12.5 match.mp4`, and `- match.mp4` without an alignment. */
    fun toText(): String = "${alignment?.startSeconds ?: NONE} $name"
}

/** Returns the note that [VideoNote.toText] wrote as [text]; null for any other text. */
fun videoNoteOf(text: String): VideoNote? {
    val (start, name) = text.split(' ', limit = 2).takeIf { it.size == 2 } ?: return null
    if (start == NONE) return VideoNote(name, null)
    return start.toDoubleOrNull()?.takeIf(Double::isFinite)?.let { VideoNote(name, VideoAlignment(it)) }
}

/**
 * Returns [notes], the stored notes about a log's videos, with this one. It replaces an older note about the same video. Each note is one
 * line.
 */
fun VideoNote.within(notes: String): String =
    (notes.lines().filter { line -> videoNoteOf(line).let { it != null && it.name != name } } + toText()).joinToString("\n")

private const val NONE = "-"
