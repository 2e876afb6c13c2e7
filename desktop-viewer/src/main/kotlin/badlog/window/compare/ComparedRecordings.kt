package badlog.window.compare

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.LogMoments
import badlog.viewer.choices.comparison.LogOffsets
import badlog.viewer.shown.comparison.DrawnLog
import badlog.viewer.shown.comparison.LogName
import badlog.viewer.shown.comparison.namesBeside
import badlog.viewer.state.CompareRequest
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingReader
import badlog.window.state.StateHolder
import badlog.window.task.LongTasks
import kotlinx.coroutines.Job
import java.nio.file.Path

/** A [recording] that graphs draw. The offset of the open one is 0. */
internal data class DrawnRecording(
    val recording: OpenRecording,
    override val offset: Double = 0.0,
    override val name: String = recording.label,
) : DrawnLog

/**
 * Reads the recordings compared with the current one, and releases them afterwards.
 *
 * @param reader reads each recording.
 */
internal class ComparedRecordings(
    private val current: CurrentRecording,
    private val tasks: LongTasks,
    private val reader: RecordingReader,
) : StateHolder<Comparison>(Comparison()) {
    private val jobs = HashMap<Path, Job>()

    /**
     * The recordings that every graph draws: the open one, then the checked ones that were read. They are in the order in which they were
     * checked. A recording that is both is included once. The index in this list selects a recording's color.
     */
    val drawn: List<DrawnRecording> by derivedStateOf {
        val open = current.recording ?: return@derivedStateOf emptyList()
        val others = state.checked.filter { it != open.file }.mapNotNull { state.loaded[it] }
        if (others.isEmpty()) return@derivedStateOf listOf(DrawnRecording(open))
        val names = namesBeside((listOf(open) + others).map(::nameOf))
        listOf(DrawnRecording(open, name = names[0])) +
            others.mapIndexed { i, other -> DrawnRecording(other, state.offsetOf(other, open), names[i + 1]) }
    }

    /** Checks or unchecks [file]. */
    fun toggle(file: Path) {
        val known = file.toAbsolutePath().normalize()
        if (known in state.checked) remove(known) else add(known)
    }

    /** Checks [file] and reads it; one that is already open is not read again. A file that cannot be read is reported and unchecked. */
    fun add(file: Path) {
        change { with(file) }
        val open = current.recording
        if (open?.file == file) change { withLoaded(open) } else load(file)
    }

    /** Unchecks [file], and releases its recording. */
    fun remove(file: Path) {
        change { without(file) }
        jobs.remove(file)?.cancel()
    }

    /** Unchecks all files. */
    fun clear() {
        state.checked.forEach(::remove)
        change { cleared() }
    }

    /** Performs [request], except choosing a file. */
    fun perform(request: CompareRequest) {
        val open = current.recording ?: return

        // The open one comes first. A log may have been removed since its row was drawn.
        fun fileOf(log: Int) = drawn.getOrNull(log + 1)?.recording?.file
        when (request) {
            CompareRequest.Choose -> Unit
            CompareRequest.Clear -> clear()
            is CompareRequest.Align -> change { alignedBy(request.alignment, open) }
            is CompareRequest.Move -> fileOf(request.log)?.let { file -> change { movedTo(file, request.offset, open) } } ?: Unit
            is CompareRequest.Remove -> fileOf(request.log)?.let(::remove) ?: Unit
        }
    }

    /** Uses [open] as the only recording of its file, if that file is checked. */
    fun share(open: OpenRecording) {
        if (state.loaded[open.file] !== open) change { withLoaded(open) }
    }

    private fun nameOf(recording: OpenRecording): LogName {
        val match = recording.match
        return LogName(match.event, match.match, recording.label, recording.file.joinToString("/"))
    }

    private fun load(file: Path) {
        val read = { progress: (Float) -> Unit -> reader.read(file, progress = progress) }
        val job = tasks.run("Reading ${file.fileName} to compare", read) { change { withLoaded(it) } }
        jobs[file] = job
        job.invokeOnCompletion {
            // Checking the same file again later starts a new job.
            if (jobs[file] !== job) return@invokeOnCompletion
            jobs.remove(file)
            if (file !in state.loaded) change { without(file) }
        }
    }
}

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
