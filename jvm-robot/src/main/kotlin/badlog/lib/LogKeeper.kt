package badlog.lib

import java.io.File
import java.time.Instant
import java.util.function.Supplier

/**
 * Handles files on its own thread, so that a robot's loop does not wait. It opens and renames the log, frees space, and stops the log when
 * there is none.
 */
internal class LogKeeper(private val session: LogSession, private val options: RobotLogOptions) : Thread("badlog keeper") {
    private val faults = session.faults
    private val folder = LogFolder(LogFolder.choose(options.folder), options.freeBytes)
    private val pauses = options.time.pauses(TICK_MILLIS)
    private val ending = if (options.isCompressed) ".bag.gz" else ".bag"
    private var time: Instant? = null
    private var event = ""
    private var match = ""
    private var ticks = 0L

    @Volatile
    private var hasLooped = false

    @Volatile
    private var isAwaited = false

    init {
        isDaemon = true
    }

    /** Marks the topics as complete. [isReason] says whether there is a reason to begin at once. */
    fun mayBegin(isReason: Boolean) {
        if (isReason) isAwaited = true
        hasLooped = true
    }

    override fun run() {
        try {
            do tick() while (pauses.next())
        } catch (failure: Throwable) {
            faults.reportOnce("keeper") { "The log's files are no longer managed: ${describe(failure)}." }
        }
    }

    /** Ends the thread soon, without waiting for it. */
    fun finish() = pauses.end()

    private fun tick() {
        if (session.state == LogState.CLOSED) return finish()
        val waited = ++ticks * TICK_MILLIS / 1000.0
        if (session.state == LogState.SETTING_UP) {
            if (hasLooped && (isAwaited || waited >= options.headerTimeout)) begin()
            return
        }
        rename()
        if (ticks % SPACE_TICKS == 0L && folder.isFull) stopLogging()
    }

    private fun begin() {
        val deleted = folder.makeSpace()
        if (deleted.isNotEmpty()) reportDeleted(deleted)
        // Before the first log there is no folder, and a missing folder has no space.
        folder.path.mkdirs()
        if (folder.isFull) return stopLogging()
        // Calls the robot's code, which may close the log meanwhile.
        updateIdentity()
        if (session.state == LogState.CLOSED) return
        addValues()
        session.begin(LogName.free(folder.path, currentName(), ending), options.isCompressed, options.move)
    }

    private fun reportDeleted(deleted: List<File>) = faults.reportOnce("deleted") {
        val names = deleted.joinToString(limit = 3, truncated = "and ${deleted.size - 3} more") { it.name }
        "The disk is nearly full; the oldest logs in ${folder.path} were deleted: $names."
    }

    private fun stopLogging() {
        faults.reportOnce("full") {
            "Logging stopped: less than 5 MiB are free in ${folder.path}. " +
                "Copy old logs to a laptop, then delete them here."
        }
        // Writes a row with the note, because there may be no other.
        if (session.state != LogState.SETTING_UP) session.log()
        session.close()
    }

    private fun rename() {
        val file = session.file ?: return
        val wasUnknown = match.isEmpty()
        if (!updateIdentity()) return
        // First, even if renaming fails: this note shows the match.
        if (wasUnknown && match.isNotEmpty()) faults.note("Match $event $match")
        if (time == null) return
        val name = LogName.free(folder.path, currentName(), ending)
        if (!session.rename(name)) {
            faults.reportOnce("rename") { "The log ${file.path} could not be renamed to ${name.name}; it keeps its name." }
            return
        }
        syncFolder(folder.path)
    }

    /** Asks for the event, the match and the time that are not known yet. Returns whether any of them is known now. */
    private fun updateIdentity(): Boolean {
        val before = Triple(time, event, match)
        if (time == null && ask("isClockSet") { options.isClockSet.asBoolean } == true) time = Instant.now()
        if (match.isEmpty()) {
            event = text("event", options.event)
            match = text("match", options.match)
        }
        return before != Triple(time, event, match)
    }

    private fun currentName() = time?.let { LogName.of(it, event, match) } ?: LogName.provisional()

    private fun addValues() {
        addValue("Event Name", event)
        addValue("Match Type", MATCH_TYPES[match.firstOrNull()] ?: "")
        addValue("Match Number", match.drop(1))
    }

    private fun addValue(name: String, text: String) {
        if (text.isEmpty()) return
        try {
            session.addValue(name, text)
        } catch (_: DuplicateNameException) {
            // The program itself created this value.
        } catch (_: InvalidModeException) {
            // The log was closed in the meantime.
        }
    }

    private fun text(name: String, supplier: Supplier<String>) = ask(name) { supplier.get() } ?: ""

    private fun <T : Any> ask(name: String, question: () -> T?): T? = try {
        question()
    } catch (failure: Throwable) {
        faults.callIgnored(name) { "$name could not be read: ${describe(failure)}. It counts as unknown." }
        null
    }

    private companion object {
        const val TICK_MILLIS = 100L
        const val SPACE_TICKS = 50L
        val MATCH_TYPES = mapOf('P' to "Practice", 'Q' to "Qualification", 'E' to "Elimination")
    }
}
