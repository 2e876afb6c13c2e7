package badlog.report

import badlog.catalog.store.CachedResult
import badlog.catalog.store.ResultCache
import badlog.files.FolderRun
import badlog.files.LogFile
import badlog.files.withShutdownHook

/**
 * Calls [work] for each of [files] that is not in [cache], with the number of cores that it may use. Passes all results to [each], in the
 * order of the files and on this thread. Lasting results are then stored in the cache's file, even if [each] throws, the thread is
 * interrupted, or the program is asked to end.
 *
 * @param waiting called on this thread several times a second until the next result is available.
 */
internal fun <R : Any> runCached(
    files: List<LogFile>,
    cache: ResultCache<R>?,
    work: (file: LogFile, cores: Int) -> CachedResult<R>,
    waiting: () -> Unit,
    each: (LogFile, R) -> Unit,
) {
    val known = files.map { cache?.get(it) }
    var next = 0
    fun giveKnown() {
        while (next < files.size) each(files[next], known[next] ?: return).also { next++ }
    }
    val remembering = { file: LogFile, cores: Int ->
        work(file, cores).let {
            if (it.isLasting) cache?.set(file, it.result)
            it.result
        }
    }
    try {
        withShutdownHook({ cache?.save() }) {
            giveKnown()
            FolderRun().forEach(files.filterIndexed { index, _ -> known[index] == null }, remembering, waiting) { file, result ->
                cache?.saveNowAndThen()
                each(file, result)
                next++
                giveKnown()
            }
        }
    } finally {
        cache?.save()
    }
}
