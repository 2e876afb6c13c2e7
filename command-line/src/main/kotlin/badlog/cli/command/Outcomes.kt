package badlog.cli.command

import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.input.LogInput
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.jsonOf
import badlog.files.NO_LOGS_SENTENCE
import badlog.files.naming
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import java.nio.file.Path

/**
 * The outcome for one log.
 *
 * @property isSalvaged whether data of the log is lost.
 * @property text the text for people.
 * @property json the properties for programs, in this order, besides file and status.
 */
internal class Outcome(val isSalvaged: Boolean, val text: String, val json: Map<String, JsonElement>)

/**
 * Reports the outcome for each log, and counts it for the exit code.
 *
 * @param isSummed whether to summarize several logs at the end; false if the results themselves end with a summary.
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

    /** Reports that [file] was processed. */
    fun done(file: Path, outcome: Outcome) {
        if (outcome.isSalvaged) salvaged++ else whole++
        if (isJson) {
            line(file, if (outcome.isSalvaged) "salvaged" else "whole", outcome.json)
        } else if (outcome.text.isNotEmpty()) {
            console.say(outcome.text)
        }
    }

    /** Reports that [file] could not be processed; [message] says why. */
    fun failed(file: Path, message: String) {
        failed++
        if (isJson) line(file, "failed", jsonOf(ErrorJson(message))) else console.fail(message)
    }

    /** Reports that [input] cannot be read; [message] says why. With [isNoLog], it is something other than a log. */
    fun unreadable(input: LogInput, message: String, isNoLog: Boolean) {
        val file = input.file
        if (isNoLog && input.isFound) skipped(file, message) else failed(file, naming(file, message))
    }

    /** Reports that [file], found in a folder, is not a log; [message] says why. */
    private fun skipped(file: Path, message: String) {
        skipped += naming(file, message)
        if (isJson) line(file, "skipped", jsonOf(SkippedJson(message)))
    }

    /** Reports that [file], found in a folder, was skipped; [message], the reason, is printed at once. */
    fun skippedPart(file: Path, message: String) {
        if (isJson) line(file, "skipped", jsonOf(SkippedJson(message))) else console.warn(message)
    }

    /** Records that something other than a log is missing in the result. Prints [message], the reason, unless it is empty. */
    fun leaveOut(message: String = "") {
        isIncomplete = true
        if (message.isNotEmpty()) console.warn(message)
    }

    /**
     * Prints the summary, and returns the exit code.
     *
     * @param isNothingFine whether it is a success if there was nothing to do.
     */
    fun end(isNothingFine: Boolean = false): ExitCode {
        listSkipped()
        val done = whole + salvaged
        val isNothing = done + failed == 0
        if (isSummed && !isJson && done + failed > 1) console.warn(summary())
        if (isNothing && !isNothingFine) console.warn(NO_LOGS_SENTENCE)
        return when {
            isNothing && isNothingFine -> if (isIncomplete) ExitCode.SALVAGED else ExitCode.WHOLE
            done == 0 -> ExitCode.NOTHING
            salvaged + failed > 0 || isIncomplete -> ExitCode.SALVAGED
            else -> ExitCode.WHOLE
        }
    }

    /** Prints which files in folders are not logs. */
    fun listSkipped() {
        if (isJson) return
        for (message in skipped.take(LISTED)) console.warn("Skipped $message")
        val more = skipped.size - LISTED
        if (more > 0) console.warn("Skipped ${counted(more.toLong(), "more file")}; --json names them.")
    }

    /** Returns a summary, such as `4 logs: 2 complete, 1 incomplete, 1 failed.` */
    private fun summary(): String {
        val parts = listOf(whole to "complete", salvaged to "incomplete", failed to "failed").filter { it.first > 0 }
        return counted((whole + salvaged + failed).toLong(), "log") + ": " +
            parts.joinToString(postfix = ".") { (count, what) -> "${grouped(count.toLong())} $what" }
    }

    private fun line(file: Path, status: String, rest: Map<String, JsonElement>) {
        console.say(Spelling.ascii(JsonObject(jsonOf(LineJson(command, file.toString(), status)) + rest).toString()))
    }
}

@Serializable
private class LineJson(private val command: String, private val file: String, private val status: String)

@Serializable
private class ErrorJson(private val error: String)

@Serializable
private class SkippedJson(private val reason: String)

/** The maximum number of listed files that are not logs. */
private const val LISTED = 20
