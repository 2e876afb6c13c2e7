package badlog.networktables.record

import java.io.Closeable
import java.io.IOException
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.thread
import kotlin.concurrent.withLock

/**
 * Writes what NetworkTables servers publish into WPILOGs, while they publish it. It subscribes to all values, and publishes none. Entries are
 * named, typed and described as WPILib's own `DataLogManager` does; times are those of the robot's server, to which the times of other
 * servers are converted. A value that was set before its file began is written at the file's start, where it holds.
 *
 * Thread-safe. Its threads end with [close], and do not keep a program running.
 *
 * @param servers the servers; the first is the robot's. Nothing is written before that was connected.
 * @param clock returns this computer's time in µs, from any moment.
 * @throws IllegalArgumentException if there are none.
 */
class Recorder internal constructor(
    servers: List<RecordedServer>,
    options: RecordOptions,
    private val listener: RecordListener,
    private val clock: () -> Long,
) : Closeable {
    constructor(servers: List<RecordedServer>, options: RecordOptions, listener: RecordListener) :
        this(servers, options, listener, { TimeUnit.NANOSECONDS.toMicros(System.nanoTime()) })

    private val inbox = Inbox(options.maxWaitingBytes)
    private val sources = servers.mapIndexed { index, server -> Source(server, isRobot = index == 0) }
    private val session: Session
    private val links: List<LinkThread>
    private val writer = thread(start = false, isDaemon = true, name = "record") { write() }
    private val lock = ReentrantLock()
    private val ended = lock.newCondition()
    private var isStarted = false

    @Volatile
    private var isEnding = false

    init {
        require(servers.isNotEmpty()) { "A recorder needs a server." }
        session = Session(sources, options, listener, inbox::dropped, clock)
        val client = LinkThread.client()
        links = sources.map { LinkThread(it, client, inbox, clock) }
    }

    /** How far it is, a moment ago at most. */
    @Volatile
    var progress: RecordProgress = session.progress
        private set

    /** Why it ended by itself: a sentence. Null if it did not. */
    @Volatile
    var failure: String? = null
        private set

    /** Starts to look for the servers. */
    fun start() {
        lock.withLock {
            check(!isStarted && !isEnding) { "A recorder starts once." }
            isStarted = true
        }
        writer.start()
        links.forEach { it.start() }
    }

    /** Waits for [millis], or until it ends by itself. Returns false if it has ended. */
    fun await(millis: Long): Boolean = lock.withLock {
        if (failure == null) ended.await(millis, TimeUnit.MILLISECONDS)
        failure == null
    }

    /** Ends all connections, writes what has arrived, and closes the file. Waits for that. */
    override fun close() {
        links.forEach { it.end() }
        if (lock.withLock { !isStarted }) return
        for (link in links) link.join(JOIN_MILLIS)
        isEnding = true
        writer.join()
    }

    private fun write() {
        try {
            while (!isEnding) {
                inbox.next(TICK_MILLIS)?.let(session::take)
                session.tick()
                progress = session.progress
            }
            generateSequence { inbox.next(0) }.forEach(session::take)
            session.finish()
        } catch (e: IOException) {
            fail("The log cannot be written (${e.message ?: e}); check the disk and the folder.")
        } catch (_: OutOfMemoryError) {
            fail("The recording ended, because there is not enough memory; close other programs and record again.")
        } catch (e: RuntimeException) {
            fail("The recording ended because of an error in badlog ($e); record again, and report it.")
        }
        progress = session.progress
    }

    private fun fail(message: String) {
        try {
            session.finish()
        } catch (_: IOException) {
            // What could not be written before is still lost.
        }
        links.forEach { it.end() }
        lock.withLock {
            failure = message
            ended.signalAll()
        }
    }

    private companion object {
        const val TICK_MILLIS = 20L
        const val JOIN_MILLIS = 3_000L
    }
}
