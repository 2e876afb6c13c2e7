package badlog.cli.command

import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.input.LogInput
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.jsonOf
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import java.nio.file.Path

/**
 * What came of one log.
 *
 * @property isSalvaged whether something of the log is lost.
 * @property text what a person reads about it.
 * @property json what a program reads about it, in this order, besides its file and status.
 */
internal class Outcome(val isSalvaged: Boolean, val text: String, val json: Map<String, JsonElement>)

/**
 * Says what came of each log, and counts it for the exit code.
 *
 * @param isSummed whether to say at the end what came of several logs; false where the results themselves end with that.
 */
internal class Outcomes(
    private val command: String,
    private val console: Console,
    private val isJson: Boolean,
    private val isSummed: Boolean = false,
) {
    private var whole = 0
    private var salvaged = 0
    private var failed = 0
    private val skipped = ArrayList<String>()
    private var isIncomplete = false

    /** [file] was worked on. */
    fun done(file: Path, outcome: Outcome) {
        if (outcome.isSalvaged) salvaged++ else whole++
        if (isJson) {
            line(file, if (outcome.isSalvaged) "salvaged" else "whole", outcome.json)
        } else if (outcome.text.isNotEmpty()) {
            console.say(outcome.text)
        }
    }

    /** Nothing could be done with [file], for the reason of [message]. */
    fun failed(file: Path, message: String) {
        failed++
        if (isJson) line(file, "failed", jsonOf(ErrorJson(message))) else console.fail(message)
    }

    /** [input] cannot be read, for the reason of [message]; [isNoLog] when it is something else than a log. */
    fun unreadable(input: LogInput, message: String, isNoLog: Boolean) {
        val file = input.file
        if (isNoLog && input.isFound) skipped(file, message) else failed(file, named(file, message))
    }

    /** [file] lies in a folder that was named and is not a log; [message] says why. */
    private fun skipped(file: Path, message: String) {
        skipped += named(file, message)
        if (isJson) line(file, "skipped", jsonOf(SkippedJson(message)))
    }

    private fun named(file: Path, message: String) = if ("$file" in message) message else "$file: $message"

    /** [file], which nobody named, was passed over for the reason of [message], which is reported at once. */
    fun passedOver(file: Path, message: String) {
        if (isJson) line(file, "skipped", jsonOf(SkippedJson(message))) else console.warn(message)
    }

    /** Something of the result is missing beside logs, for the reason of [message], which may be reported already. */
    fun leaveOut(message: String = "") {
        isIncomplete = true
        if (message.isNotEmpty()) console.warn(message)
    }

    /**
     * Says what there is to say about all; how the program ends.
     *
     * @param isNothingFine whether it is as well when there was nothing to do.
     */
    fun end(isNothingFine: Boolean = false): ExitCode {
        if (!isJson) {
            for (message in skipped.take(LISTED)) console.warn("Skipped $message")
            val more = skipped.size - LISTED
            if (more > 0) console.warn("Skipped ${counted(more.toLong(), "more file")}; --json names them.")
        }
        val done = whole + salvaged
        val isNothing = done + failed == 0
        if (isSummed && !isJson && done + failed > 1) console.warn(summary())
        if (isNothing && !isNothingFine) console.warn("No logs found. Name a log, or the folder it is in.")
        return when {
            isNothing && isNothingFine -> if (isIncomplete) ExitCode.SALVAGED else ExitCode.WHOLE
            done == 0 -> ExitCode.NOTHING
            salvaged + failed > 0 || isIncomplete -> ExitCode.SALVAGED
            else -> ExitCode.WHOLE
        }
    }

    /** Such as `4 logs: 2 complete, 1 incomplete, 1 failed.` */
    private fun summary(): String {
        val parts = listOf(whole to "complete", salvaged to "incomplete", failed to "failed").filter { it.first > 0 }
        return counted((whole + salvaged + failed).toLong(), "log") + ": " +
            parts.joinToString(postfix = ".") { (count, what) -> "${grouped(count.toLong())} $what" }
    }

    private fun line(file: Path, status: String, rest: Map<String, JsonElement>) {
        console.say(Spelling.ascii(JsonObject(jsonOf(LineJson(command, file.toString(), status)) + rest).toString()))
    }

    private companion object {
        /** So many files that are no logs are named. */
        const val LISTED = 20
    }
}

@Serializable
private class LineJson(private val command: String, private val file: String, private val status: String)

@Serializable
private class ErrorJson(private val error: String)

@Serializable
private class SkippedJson(private val reason: String)
