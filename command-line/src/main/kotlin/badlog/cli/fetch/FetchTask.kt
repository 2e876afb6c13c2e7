package badlog.cli.fetch

import badlog.cli.command.ExitCode
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.sizeText
import badlog.fetch.FetchException
import badlog.fetch.FetchListener
import badlog.fetch.FetchOptions
import badlog.fetch.FetchQuestions
import badlog.fetch.FetchedLog
import badlog.fetch.FoundLogs
import badlog.fetch.KnownHosts
import badlog.fetch.LogFetch
import badlog.fetch.RobotAddress
import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.terminal.ProgressBar
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * Fetches new logs from the robot at one of [addresses]; repeatedly if [isWatching].
 */
internal class FetchTask(
    private val addresses: List<RobotAddress>,
    private val options: FetchOptions,
    private val robots: Robots,
    private val isWatching: Boolean,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("fetch", console, isJson)
        val questions = System.console()?.let(::TerminalQuestions) ?: FetchQuestions.NOBODY
        val hosts = KnownHosts(robots.settings.resolve("known_hosts"))
        val fetch = LogFetch(addresses, options, hosts, questions, robots.patience)
        FetchTalk(console, outcomes).use { talk ->
            try {
                do {
                    val error = once(fetch, talk)
                    if (error == null) talk.endRound() else talk.fail(error)
                    if (isWatching) Thread.sleep(WATCH_MILLIS)
                } while (isWatching)
            } catch (_: InterruptedException) {
                // The person stopped watching.
            }
        }
        return outcomes.end(isNothingFine = true)
    }

    /** Fetches all new logs. Returns the reason if that fails, or null. */
    private fun once(fetch: LogFetch, talk: FetchTalk): String? = try {
        fetch.run(talk)
        null
    } catch (e: FetchException) {
        e.message
    } catch (e: UnwritableFileException) {
        e.message
    } catch (e: UnreadableFileException) {
        e.message
    }

    /** Reports events. While watching, only changes are reported. */
    private inner class FetchTalk(private val console: Console, private val outcomes: Outcomes) :
        FetchListener,
        AutoCloseable {
        private var address = addresses.first()
        private val said = HashSet<String>()
        private var known = 0
        private var isNothing = false
        private var bar: ProgressBar? = null
        private var barName = ""

        override fun connected(address: RobotAddress, user: String) {
            this.address = address
            report("Connected to $address as $user.")
        }

        override fun waiting(address: RobotAddress) = warn("The robot is enabled; waiting until it is disabled.")

        override fun retrying(address: RobotAddress, reason: String) = warn("The connection to $address was lost ($reason); trying again.")

        override fun found(logs: FoundLogs) {
            isNothing = logs.newLogs == 0
            known = logs.knownLogs
            if (!isNothing) warn("${counted(logs.newLogs.toLong(), "new log")}, ${sizeText(logs.newBytes)}.")
        }

        override fun advanced(name: String, done: Long, total: Long) {
            if (barName != name || bar == null) {
                close()
                bar = console.progress(name)
                barName = name
            }
            bar?.advanced(done, total)
        }

        override fun fetched(log: FetchedLog) {
            close()
            val json = jsonOf(FetchJson(address.name, log.path, log.bytes, log.resumedAt, log.title, log.isLog))
            val parts = listOfNotNull(
                log.title,
                sizeText(log.bytes),
                "the first ${sizeText(log.resumedAt)} were already here".takeIf { log.resumedAt > 0 },
                if (!log.isLog) {
                    "cannot be read; badlog info says why"
                } else if (log.isSalvaged) {
                    "damaged; badlog info says what is lost"
                } else {
                    null
                },
            )
            outcomes.done(log.file, Outcome(!log.isLog || log.isSalvaged, "${log.file}: ${parts.joinToString()}", json))
        }

        override fun skipped(path: String, message: String, isGrowing: Boolean) {
            close()
            if (!isGrowing) outcomes.leaveOut()
            outcomes.skippedPart(Path.of(path.ifEmpty { "/" }), message)
        }

        override fun deleted(path: String) = warn("$path was removed from the robot; the copy is safe here.")

        /** Records that a round was successful. */
        fun endRound() {
            close()
            if (isNothing) report("Nothing new on $address; ${counted(known.toLong(), "log")} fetched before.")
        }

        /** Records that a round failed; [message] says why. */
        fun fail(message: String) {
            close()
            if (message in said) return
            // While watching, the robot is reported again when it is back.
            said.clear()
            said += message
            if (isWatching && !isJson) console.warn(message) else outcomes.failed(options.folder, message)
        }

        override fun close() {
            bar?.close()
            bar = null
        }

        private fun report(message: String) {
            if (isWatching && !said.add(message)) return
            warn(message)
        }

        private fun warn(message: String) {
            close()
            if (!isJson) console.warn(message)
        }
    }
}

@Serializable
private class FetchJson(
    private val robot: String,
    private val path: String,
    private val bytes: Long,
    private val resumedAt: Long,
    private val match: String?,
    private val isLog: Boolean,
)

/** The time between rounds while watching. */
private const val WATCH_MILLIS = 5_000L
