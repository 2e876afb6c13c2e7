package badlog.viewer.compare

import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import kotlinx.coroutines.Job
import java.nio.file.Path

/** Reads the recordings that are compared, and lets go of those that no longer are. To be used on the window's thread only. */
internal class ComparisonLoading(private val viewer: Viewer) {
    private val jobs = HashMap<Path, Job>()

    /** Ticks [file] and reads it; one that is open already is not read again. One that cannot be read is said and unticked. */
    fun add(file: Path) {
        viewer.comparison = viewer.comparison.with(file)
        val open = viewer.open
        if (open?.file == file) viewer.comparison = viewer.comparison.withLoaded(open) else load(file)
    }

    /** Takes the tick of [file] away, and what was read of it. */
    fun remove(file: Path) {
        viewer.comparison = viewer.comparison.without(file)
        jobs.remove(file)?.cancel()
    }

    /** Takes all ticks away. */
    fun clear() {
        viewer.comparison.ticked.forEach(::remove)
        viewer.comparison = viewer.comparison.cleared()
    }

    /** Keeps [open] as the one copy of its file, where that is ticked. */
    fun share(open: OpenRecording) {
        if (viewer.comparison.loaded[open.file] !== open) viewer.comparison = viewer.comparison.withLoaded(open)
    }

    private fun load(file: Path) {
        val read = { progress: (Float) -> Unit -> OpenRecording.read(file, { viewer.formulas }, progress = progress) }
        val job = viewer.tasks.run("Reading ${file.fileName} to compare", read) { viewer.comparison = viewer.comparison.withLoaded(it) }
        jobs[file] = job
        job.invokeOnCompletion {
            // A later tick of the same file has a job of its own.
            if (jobs[file] !== job) return@invokeOnCompletion
            jobs.remove(file)
            if (file !in viewer.comparison.loaded) viewer.comparison = viewer.comparison.without(file)
        }
    }
}

/** Ticks the recording in [file], or takes its tick away. */
internal fun toggleCompared(viewer: Viewer, file: Path) {
    val known = file.toAbsolutePath().normalize()
    if (known in viewer.comparison.ticked) viewer.comparisonLoading.remove(known) else viewer.comparisonLoading.add(known)
}
