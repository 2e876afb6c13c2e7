package badlog.lib

import java.io.File
import java.util.concurrent.atomic.AtomicBoolean

/**
 * One log from setup to end. A mistake during setup throws an exception; [update], [log] and [publishing] never throw.
 *
 * There are two kinds of locks, so that no thread waits unnecessarily: [lock] is held while a row is built and written, and each
 * [SubscribedTopic] has its own for its published values. None is held while suppliers are called.
 */
internal class LogSession(private val flushesEachRow: Boolean, private val time: LogTime = LogTime()) {
    private val lock = Any()
    private val namespace = Namespace()
    private val isSampling = AtomicBoolean()
    private val closeOnExit = CloseOnExit(this)
    private var topics = emptyArray<Topic>()
    private var sink: RowSink? = null
    private var syncThread: SyncThread? = null
    private var syncs = true

    /** Whether a row is being built: a caller that then holds the lock is the program's own formatter. Guarded by the lock. */
    private var isInRow = false
    private var closesAfterRow = false

    val faults: Faults = Faults(Counters())
    val text: NumberText = NumberText(faults)

    /** The file, or null while there is none. */
    @Volatile
    var file: LogFile? = null
        private set

    // Empty until the setup is finished, so that publishing needs no lock.
    @Volatile
    private var subscribers: Map<String, SubscribedTopic> = emptyMap()

    @Volatile
    private var phase = LogState.SETTING_UP

    val state: LogState
        get() = if (phase == LogState.LOGGING && !isWritable()) LogState.FAILING else phase

    /** Creates the file; reports a failure once. */
    fun open(path: File, isCompressed: Boolean) {
        LogFile.open(path, isCompressed, faults)?.let(::logTo)
    }

    /** Logs to [opened], unless the log was closed while the file was being opened. */
    fun logTo(opened: LogFile) {
        synchronized(lock) {
            if (phase != LogState.SETTING_UP) return opened.discard(faults)
            file = opened
            sink = RowSink(opened, flushesEachRow, faults, time)
            closeOnExit.register()
        }
    }

    /** Creates the file and ends the setup, or does neither if the log is closed in the meantime. */
    fun begin(path: File, isCompressed: Boolean, move: (from: File, to: File) -> Boolean = File::renameTo) {
        // Without the lock, because a disk may be slow, and publishers may need the lock.
        val opened = LogFile.open(path, isCompressed, faults, move)
        synchronized(lock) {
            opened?.let(::logTo)
            if (phase == LogState.SETTING_UP) finishSetup()
        }
    }

    /** Renames the log's file to [to], without losing a row. If renaming fails, returns false, and the name is unchanged. */
    fun rename(to: File): Boolean = file?.rename(to, lock) ?: false

    fun <T : Topic> add(topic: T): T {
        synchronized(lock) {
            requireSettingUp(topic.name)
            namespace.add(topic)
        }
        return topic
    }

    fun addValue(name: String, value: String) {
        synchronized(lock) {
            requireSettingUp(name)
            namespace.addValue(name, value)
        }
    }

    fun finishSetup() {
        synchronized(lock) {
            if (phase != LogState.SETTING_UP) {
                throw InvalidModeException("The log was set up already: call finishInitialization() only once.")
            }
            topics = namespace.topics.toTypedArray()
            subscribers = topics.filterIsInstance<SubscribedTopic>().associateBy { it.name }
            faults.room = topics.firstOrNull { it is EventTopic } as EventTopic?
                ?: topics.firstOrNull { it is SubscribedTopic && it.isEventLog } as SubscribedTopic?
            val events = topics.filterIsInstance<EventSink>().map { it.texts }.toTypedArray()
            sink?.begin(namespace.headerLines(), events)
            phase = LogState.LOGGING
            startSyncing()
        }
    }

    fun update() {
        if (phase != LogState.LOGGING) return ignored("updateTopics()")
        // The suppliers' code may take locks of its own, or call this again. For a second thread, the work is already
        // being done.
        if (!isSampling.compareAndSet(false, true)) return
        try {
            for (topic in topics) topic.sample()
            synchronized(lock) {
                if (isInRow) return ignored("updateTopics()")
                text.commit()
                for (topic in topics) topic.commit()
            }
        } finally {
            isSampling.set(false)
        }
    }

    fun log() {
        synchronized(lock) {
            if (phase != LogState.LOGGING || isInRow) return ignored("log()")
            val sink = sink
            if (sink == null) faults.counters.rowsMissed.incrementAndGet() else writeRow(sink)
            if (closesAfterRow) close()
        }
    }

    private fun writeRow(sink: RowSink) {
        val began = time.now
        if (sink.isRefusing(began)) return sink.missRow()
        try {
            isInRow = true
            val row = sink.row
            for (topic in topics) topic.write(row)
            isInRow = false
            sink.endRow(began)
        } catch (failure: Throwable) {
            // For example, too little memory for a text: this row is lost, but the robot keeps running.
            isInRow = false
            sink.dropRow()
            faults.reportOnce("row") { "A row of the log was lost: ${describe(failure)}." }
        }
    }

    fun flush() {
        synchronized(lock) {
            if (phase == LogState.LOGGING && !isInRow) sink?.flush()
        }
    }

    /** Returns the topic to publish to, or null if the call is to be ignored. */
    fun publishing(name: String?, isNull: Boolean): SubscribedTopic? {
        val topic = subscribers[name] ?: earlySubscriber(name)
        if (topic != null && !isNull) return topic
        faults.publishIgnored(name) {
            if (topic != null) {
                nullPublished(topic.name)
            } else {
                "Values published to \"$name\" are ignored: createTopicSubscriber() was not called for it."
            }
        }
        return null
    }

    /**
     * Returns the topic [name] during setup. Values published then are kept for the first row, because the setup of a [RobotLog] may take
     * long.
     */
    private fun earlySubscriber(name: String?): SubscribedTopic? {
        if (phase != LogState.SETTING_UP) return null
        return synchronized(lock) { namespace.topics.firstOrNull { it.name == name } as? SubscribedTopic }
    }

    fun setSyncing(enabled: Boolean) {
        synchronized(lock) {
            syncs = enabled
            syncThread?.syncs = enabled
        }
    }

    fun close() {
        synchronized(lock) {
            if (phase == LogState.CLOSED) return
            if (isInRow) {
                closesAfterRow = true
                return
            }
            phase = LogState.CLOSED
            sink?.finish()
            val thread = syncThread
            syncThread = null
            if (thread != null) thread.finish() else file?.close(faults)
        }
        if (file != null && Thread.currentThread() !== closeOnExit) closeOnExit.unregister()
    }

    private fun isWritable() = sink?.isFailing == false && file?.isMissing == false

    private fun requireSettingUp(name: String) {
        if (phase != LogState.SETTING_UP) {
            throw InvalidModeException(
                "\"$name\" was created too late: create all topics and values before finishInitialization().",
            )
        }
    }

    private fun ignored(call: String) = faults.callIgnored(call) {
        when (phase) {
            LogState.CLOSED -> "$call is ignored, because the log was closed."
            LogState.SETTING_UP -> "$call is ignored until finishInitialization() is called."
            else -> "$call is ignored while a row is being written; do not call it from the function given to setDoubleToStringFunction()."
        }
    }

    private fun startSyncing() {
        val file = file
        val sink = sink
        if (syncThread == null && file != null && sink != null) {
            syncThread = SyncThread(file, sink, faults, syncs, time, ::flushWaiting).also { it.start() }
        }
    }

    private fun flushWaiting() {
        synchronized(lock) {
            if (phase == LogState.LOGGING) sink?.flushWaiting()
        }
    }
}

/** Closes a log, and so writes its buffered rows, when its program ends normally. */
internal class CloseOnExit(private val session: LogSession) : Thread("badlog close") {
    override fun run() {
        session.close()
        // A report of the fault that ends the program must still be printed.
        StandardError.awaitPrinted(MAX_PRINT_MILLIS)
    }

    fun register() = unlessExiting { Runtime.getRuntime().addShutdownHook(this) }

    fun unregister() = unlessExiting { Runtime.getRuntime().removeShutdownHook(this) }

    private inline fun unlessExiting(action: () -> Unit) {
        try {
            action()
        } catch (_: IllegalStateException) {
            // The program is ending already.
        }
    }
}

private const val MAX_PRINT_MILLIS = 250
