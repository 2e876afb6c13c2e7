package badlog.viewer.compare

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.viewer.part.Part
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.RecordingReader
import badlog.viewer.task.LongTasks
import kotlinx.coroutines.Job
import java.nio.file.Path

/**
 * The recordings that are laid over the current one: reads them, and lets go of those that no longer are.
 *
 * @param reader reads each.
 */
internal class ComparedRecordings(
    private val current: CurrentRecording,
    private val tasks: LongTasks,
    private val reader: RecordingReader,
) : Part<Comparison>(Comparison()) {
    private val jobs = HashMap<Path, Job>()

    /**
     * The recordings that every graph draws: the open one, then those checked that were read, in the order of their checks. One that
     * is both is there once. The place in this list is the place of a recording's color, see [colorOf].
     */
    val drawn: List<DrawnRecording> by derivedStateOf {
        val open = current.recording ?: return@derivedStateOf emptyList()
        val others = state.checked.filter { it != open.file }.mapNotNull { state.loaded[it] }
        if (others.isEmpty()) return@derivedStateOf listOf(DrawnRecording(open))
        val names = namesOf(listOf(open) + others)
        listOf(DrawnRecording(open, name = names[0])) +
            others.mapIndexed { i, other -> DrawnRecording(other, state.offsetOf(other, open), names[i + 1]) }
    }

    /** Checks [file], or no longer. */
    fun toggle(file: Path) {
        val known = file.toAbsolutePath().normalize()
        if (known in state.checked) remove(known) else add(known)
    }

    /** Checks [file] and reads it; one that is open already is not read again. One that cannot be read is reported and unchecked. */
    fun add(file: Path) {
        change { with(file) }
        val open = current.recording
        if (open?.file == file) change { withLoaded(open) } else load(file)
    }

    /** Unchecks [file], and lets go of what was read of it. */
    fun remove(file: Path) {
        change { without(file) }
        jobs.remove(file)?.cancel()
    }

    /** Unchecks all. */
    fun clear() {
        state.checked.forEach(::remove)
        change { cleared() }
    }

    /** Keeps [open] as the one copy of its file, where that is checked. */
    fun share(open: OpenRecording) {
        if (state.loaded[open.file] !== open) change { withLoaded(open) }
    }

    private fun load(file: Path) {
        val read = { progress: (Float) -> Unit -> reader.read(file, progress = progress) }
        val job = tasks.run("Reading ${file.fileName} to compare", read) { change { withLoaded(it) } }
        jobs[file] = job
        job.invokeOnCompletion {
            // A later check of the same file has a job of its own.
            if (jobs[file] !== job) return@invokeOnCompletion
            jobs.remove(file)
            if (file !in state.loaded) change { without(file) }
        }
    }
}
