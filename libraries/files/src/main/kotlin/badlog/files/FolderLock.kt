package badlog.files

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.TimeUnit.NANOSECONDS
import java.util.concurrent.locks.ReentrantLock
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Runs [work], which reads a file in [folder], changes its content and writes it again, under a lock. Other threads and programs that use this
 * function wait meanwhile. The lock is a hidden file in [folder], which stays there. [work] runs without a lock if none can be taken, as in some
 * folders of a network, or if none is free within a second.
 *
 * @throws InterruptedException if the thread was interrupted while waiting.
 */
public fun <T> locking(folder: Path, work: () -> T): T {
    // Two threads of one program cannot wait for one file lock. It would end with the first of their channels that is closed.
    if (!ownThreads.tryLock(PATIENCE.inWholeNanoseconds, NANOSECONDS)) return work()
    try {
        val channel = lockFileIn(folder) ?: return work()
        return channel.use {
            it.awaitLock()
            work()
        }
    } finally {
        ownThreads.unlock()
    }
}

private fun lockFileIn(folder: Path): FileChannel? = try {
    Files.createDirectories(folder)
    FileChannel.open(folder.resolve(NAME), CREATE, WRITE)
} catch (_: IOException) {
    null
}

private fun FileChannel.awaitLock() {
    val began = TimeSource.Monotonic.markNow()
    try {
        while (!takesLock() && began.elapsedNow() < PATIENCE) Thread.sleep(PAUSE.inWholeMilliseconds)
    } catch (_: IOException) {
        // This file system has no locks.
    }
}

private fun FileChannel.takesLock(): Boolean = try {
    tryLock() != null
} catch (_: OverlappingFileLockException) {
    false
}

private val ownThreads = ReentrantLock()
private const val NAME = ".badlog.lock"
private val PATIENCE = 1.seconds
private val PAUSE = 2.milliseconds
