package badlog.window.task

/**
 * Returns to the system the memory that work on a large log no longer needs. Java does so only when its memory is collected, and nothing else
 * collects it while a person looks at graphs. All threads wait meanwhile: 0.3 s for a log of 50 million values.
 */
internal fun returnUnusedMemory() = System.gc()
