package badlog.networktables.record

import java.io.Closeable
import java.io.IOException
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.thread
import kotlin.concurrent.withLock

/**
 * Records the values of NetworkTables servers live into WPILOGs. It subscribes to all values and publishes none. Entries have the names,
 * types and metadata of WPILib's own `DataLogManager`. Times are the robot server's; times of other servers are converted. A value set
 * before its file began is written at the file's start.
 *
 * Thread-safe. Its threads end with [close], and do not keep a program running.
 *
 * @param servers the servers; the first is the robot's. Nothing is written until it has connected.
 * @param clock returns this computer's time in µs, from an arbitrary origin.
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
    private val session: RecordSession
    private val links: List<LinkThread>
    private val writer = thread(start = false, isDaemon = true, name = "record") { write() }
    private val lock = ReentrantLock()
    private val ended = lock.newCondition()
    private var isStarted = false

    @Volatile
    private var isEnding = false

    init {
        require(servers.isNotEmpty()) { "A recorder needs a server." }
        session = RecordSession(sources, options, listener, inbox::dropped, clock)
        val client = LinkThread.client()
        links = sources.map { LinkThread(it, client, inbox, clock) }
    }

    /** The current progress, at most a moment old. */
    @Volatile
    var progress: RecordProgress = session.progress
        private set

    /** The reason why the recorder stopped by itself, as a sentence; null if it did not. */
    @Volatile
    var failure: String? = null
        private set

    /** Starts looking for the servers. */
    fun start() {
        lock.withLock {
            check(!isStarted && !isEnding) { "A recorder can be started only once." }
            isStarted = true
        }
        writer.start()
        links.forEach { it.start() }
    }

    /** Waits for [millis], or until the recorder stops by itself. Returns false if it has stopped. */
    fun await(millis: Long): Boolean = lock.withLock {
        if (failure == null) ended.await(millis, TimeUnit.MILLISECONDS)
        failure == null
    }

    /** Ends all connections, writes all received values, and closes the file. Blocks until that is done. */
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
            // Data from an earlier failed write stays lost.
        }
        links.forEach { it.end() }
        lock.withLock {
            failure = message
            ended.signalAll()
        }
    }
}

private const val TICK_MILLIS = 20L
private const val JOIN_MILLIS = 3_000L
