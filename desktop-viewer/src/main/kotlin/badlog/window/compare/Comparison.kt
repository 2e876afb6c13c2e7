package badlog.window.compare

import badlog.window.log.OpenRecording
import java.nio.file.Path

/**
 * Which recordings are compared with the open one, and how. Immutable; each transition returns a new one. Files are absolute
 * and normalized.
 *
 * @property checked their files, in the order in which they were checked.
 * @property loaded those of [checked] that were read.
 * @property alignment which moments are aligned.
 * @property handOffsets the manual offset of each, in units of x; only differences between them matter, and a file that is not
 *   in it has 0.
 */
internal data class Comparison(
    val checked: List<Path> = emptyList(),
    val loaded: Map<Path, OpenRecording> = emptyMap(),
    val alignment: Alignment = Alignment.START,
    val handOffsets: Map<Path, Double> = emptyMap(),
) {
    /** Adds [file] at the end, if it is not there yet. */
    fun with(file: Path): Comparison = if (file in checked) this else copy(checked = checked.plusElement(file))

    /** Removes [file] and its recording. */
    fun without(file: Path): Comparison = copy(
        // Not by minus: a path is also the collection of its parts.
        checked = checked.filter { it != file },
        loaded = loaded.filterKeys { it != file },
        handOffsets = handOffsets.filterKeys { it != file },
    )

    /** Adds [recording], if its file is still checked. */
    fun withLoaded(recording: OpenRecording): Comparison =
        if (recording.file in checked) copy(loaded = loaded + (recording.file to recording)) else this

    /** Removes all; the alignment stays for the next ones. */
    fun cleared(): Comparison = Comparison(alignment = alignment)

    /** Returns the offset of [recording] in x that aligns it with the same moment of [open]; always finite. */
    fun offsetOf(recording: OpenRecording, open: OpenRecording): Double {
        if (recording.file == open.file) return 0.0
        val offset = when (alignment) {
            Alignment.MANUAL -> handOffset(recording.file) - handOffset(open.file)
            else -> alignment.momentIn(open) - alignment.momentIn(recording)
        }
        return if (offset.isFinite()) offset else 0.0
    }

    /** Aligns by [wanted]; for manual alignment, each stays where it is. */
    fun alignedBy(wanted: Alignment, open: OpenRecording?): Comparison {
        if (wanted != Alignment.MANUAL || alignment == Alignment.MANUAL || open == null) return copy(alignment = wanted)
        val offsets = loaded.values.associate { it.file to offsetOf(it, open) } + (open.file to 0.0)
        return copy(alignment = wanted, handOffsets = offsets)
    }

    /** Moves [file] to [offset] relative to [open], which makes the alignment manual. An offset that is not a number is ignored. */
    fun movedTo(file: Path, offset: Double, open: OpenRecording): Comparison {
        if (!offset.isFinite() || file == open.file) return this
        val byHand = alignedBy(Alignment.MANUAL, open)
        return byHand.copy(handOffsets = byHand.handOffsets + (file to byHand.handOffset(open.file) + offset))
    }

    private fun handOffset(file: Path) = handOffsets[file] ?: 0.0
}

/**
 * Which moment of each recording is at the same x.
 *
 * @property title its label in the window.
 * @property hint what it does, as a sentence.
 * @property layoutName its name in layout files; must never change.
 */
internal enum class Alignment(val title: String, val hint: String, val layoutName: String) {
    /** The first x. */
    START("Start", "Every log starts where the open one starts.", "START"),

    /** The first moment at which the robot was enabled; the first x if that is unknown. */
    ENABLED(
        "Enabled",
        "The robot is first enabled at the same time in all logs; a log without that time starts with the open one.",
        "ENABLED",
    ),

    /** The x that was logged. */
    NONE("No alignment", "Every log keeps its own x.", "AS_LOGGED"),

    /** The place to which a person moved it. */
    MANUAL("Manual", "You move each log yourself.", "BY_HAND"),
}

/** Returns the x in [recording] that this alignment aligns with that of the others. */
internal fun Alignment.momentIn(recording: OpenRecording): Double = when (this) {
    Alignment.START -> recording.firstX
    Alignment.ENABLED -> recording.enabled.firstOrNull()?.span?.from ?: recording.firstX
    Alignment.NONE, Alignment.MANUAL -> 0.0
}
