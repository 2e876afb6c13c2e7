package badlog.viewer.compare

import badlog.viewer.recording.OpenRecording
import java.nio.file.Path

/**
 * Which recordings are laid over the open one, and how. Never changes; each transition gives a new one. Files are absolute and
 * normalized.
 *
 * @property checked the files of those, in the order in which they were checked.
 * @property loaded those of [checked] that were read.
 * @property alignment which moment of each stands at one place.
 * @property handOffsets by how much a person has moved each, in units of x; it is moved against the others, so only differences
 *   count, and a file that is not in it has 0.
 */
internal data class Comparison(
    val checked: List<Path> = emptyList(),
    val loaded: Map<Path, OpenRecording> = emptyMap(),
    val alignment: Alignment = Alignment.START,
    val handOffsets: Map<Path, Double> = emptyMap(),
) {
    /** Adds [file] at the end, where it is not there yet. */
    fun with(file: Path): Comparison = if (file in checked) this else copy(checked = checked.plusElement(file))

    /** Takes [file] out, and lets go of what was read of it. */
    fun without(file: Path): Comparison = copy(
        // Not by minus: a path is also the collection of its parts.
        checked = checked.filter { it != file },
        loaded = loaded.filterKeys { it != file },
        handOffsets = handOffsets.filterKeys { it != file },
    )

    /** Keeps [recording], where its file is still checked. */
    fun withLoaded(recording: OpenRecording): Comparison =
        if (recording.file in checked) copy(loaded = loaded + (recording.file to recording)) else this

    /** Takes all out; the alignment stays for the next. */
    fun cleared(): Comparison = Comparison(alignment = alignment)

    /** By how much the x of [recording] is moved, so that it stands where [open] has the same moment; always finite. */
    fun offsetOf(recording: OpenRecording, open: OpenRecording): Double {
        if (recording.file == open.file) return 0.0
        val offset = when (alignment) {
            Alignment.MANUAL -> handOffset(recording.file) - handOffset(open.file)
            else -> alignment.momentIn(open) - alignment.momentIn(recording)
        }
        return if (offset.isFinite()) offset else 0.0
    }

    /** Aligns by [wanted]; by hand, each stays where it stands now. */
    fun alignedBy(wanted: Alignment, open: OpenRecording?): Comparison {
        if (wanted != Alignment.MANUAL || alignment == Alignment.MANUAL || open == null) return copy(alignment = wanted)
        val offsets = loaded.values.associate { it.file to offsetOf(it, open) } + (open.file to 0.0)
        return copy(alignment = wanted, handOffsets = offsets)
    }

    /** Moves [file] to [offset] against [open], from now on by hand. An offset that is not a number changes nothing. */
    fun movedTo(file: Path, offset: Double, open: OpenRecording): Comparison {
        if (!offset.isFinite() || file == open.file) return this
        val byHand = alignedBy(Alignment.MANUAL, open)
        return byHand.copy(handOffsets = byHand.handOffsets + (file to byHand.handOffset(open.file) + offset))
    }

    private fun handOffset(file: Path) = handOffsets[file] ?: 0.0
}

/**
 * Which moment of each recording stands at the same x.
 *
 * @property title what the window calls it.
 * @property hint what it does, in a sentence.
 * @property layoutName what layout files call it; never to be changed.
 */
internal enum class Alignment(val title: String, val hint: String, val layoutName: String) {
    /** The first x. */
    START("Start", "Every log starts where the open one starts.", "START"),

    /** The first moment at which the robot was enabled; the first x where that is unknown. */
    ENABLED(
        "Enabled",
        "The robot is first enabled at the same time in all logs; a log without that time starts with the open one.",
        "ENABLED",
    ),

    /** The x that was logged. */
    NONE("No alignment", "Every log keeps its own x.", "AS_LOGGED"),

    /** What a person has moved it to. */
    MANUAL("Manual", "You move each log yourself.", "BY_HAND"),
}

/** The x in [recording] that this alignment puts at one place with that of the others. */
internal fun Alignment.momentIn(recording: OpenRecording): Double = when (this) {
    Alignment.START -> recording.firstX
    Alignment.ENABLED -> recording.enabled.firstOrNull()?.span?.from ?: recording.firstX
    Alignment.NONE, Alignment.MANUAL -> 0.0
}
