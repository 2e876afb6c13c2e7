package badlog.window.task

/**
 * Returns to the system the memory that reading [samples] values and running rules over them took and no longer needs. Java does so only when
 * its memory is collected, and nothing else collects it while a person looks at graphs. All threads wait meanwhile: 0.3 s for 50 million values.
 */
internal fun returnUnusedMemory(samples: Long) {
    if (samples >= LARGE_LOG) System.gc()
}

private const val LARGE_LOG = 5_000_000L
