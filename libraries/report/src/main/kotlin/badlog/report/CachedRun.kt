package badlog.report

import badlog.file.FolderRun
import badlog.file.LogFile
import badlog.report.hook.withShutdownHook

/** What was found out about a file; [isLasting] when it stays so as long as the file is the same. */
internal class CachedResult<out R>(val result: R, val isLasting: Boolean)

/**
 * Does [work], with so many cores, on those of [files] that [cache] does not know, and gives all results in the order of the files to
 * [each] on this thread. What lasts is in the cache's file afterwards, also when [each] throws, the thread is interrupted, or the
 * program is asked to end.
 */
internal fun <R : Any> runCached(
    files: List<LogFile>,
    cache: ResultCache<R>?,
    work: (file: LogFile, cores: Int) -> CachedResult<R>,
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
            FolderRun().forEach(files.filterIndexed { index, _ -> known[index] == null }, remembering) { file, result ->
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
