package badlog.window.compare

import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.LogMoments
import badlog.viewer.choices.comparison.LogOffsets
import badlog.window.log.OpenRecording
import java.nio.file.Path

/**
 * The recordings compared with the open one, and their offsets. Immutable; each transition returns a new one. Files are absolute and
 * normalized.
 *
 * @property checked the files of the recordings, in the order in which they were checked.
 * @property loaded the recordings of [checked] that were read.
 * @property offsets the offset of each on x.
 */
internal data class Comparison(
    val checked: List<Path> = emptyList(),
    val loaded: Map<Path, OpenRecording> = emptyMap(),
    val offsets: LogOffsets<Path> = LogOffsets(),
) {
    /** Adds [file] at the end, if it is not there yet. */
    fun with(file: Path): Comparison = if (file in checked) this else copy(checked = checked.plusElement(file))

    /** Removes [file] and its recording. */
    fun without(file: Path): Comparison = copy(
        // `minus` would remove the parts of the path, which is also a collection.
        checked = checked.filter { it != file },
        loaded = loaded.filterKeys { it != file },
        offsets = offsets.without(file),
    )

    /** Adds [recording], if its file is still checked. */
    fun withLoaded(recording: OpenRecording): Comparison =
        if (recording.file in checked) copy(loaded = loaded + (recording.file to recording)) else this

    /** Removes all recordings; the alignment stays for the next ones. */
    fun cleared(): Comparison = Comparison(offsets = LogOffsets(offsets.alignment))

    /** Returns the offset of [recording] in x that aligns it with the same moment of [open]; always finite. */
    fun offsetOf(recording: OpenRecording, open: OpenRecording): Double =
        offsets.of(recording.file, open.file, momentsOf(listOf(recording, open)))

    /** Aligns the recordings by [wanted]; a manual alignment keeps the current offsets. */
    fun alignedBy(wanted: Alignment, open: OpenRecording): Comparison =
        copy(offsets = offsets.alignedBy(wanted, open.file, momentsOf(loaded.values + open)))

    /** Moves [file] to [offset] relative to [open], which makes the alignment manual. An offset that is not a number is ignored. */
    fun movedTo(file: Path, offset: Double, open: OpenRecording): Comparison =
        copy(offsets = offsets.moved(file, offset, open.file, momentsOf(loaded.values + open)))

    private fun momentsOf(recordings: Collection<OpenRecording>): Map<Path, LogMoments> =
        recordings.associate { it.file to LogMoments(it.firstX, it.enabled.firstOrNull()?.span?.from) }
}
