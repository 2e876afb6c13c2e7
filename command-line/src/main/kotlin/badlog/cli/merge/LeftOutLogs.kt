package badlog.cli.merge

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.files.LogMaker
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/** A sentence about each log that is left out of this match. */
internal val Recording.leftOutLogs: List<String> get() = leftOutIn(problems)

/** Remembers the logs that [maker] leaves out of the logs that it makes. Thread-safe. */
internal class LeftOutLogs(private val maker: LogMaker) : LogMaker {
    private val found = ConcurrentHashMap<Path, List<String>>()

    /** Returns a sentence about each log that is left out of the one made of [file]. */
    fun of(file: Path): List<String> = found[file].orEmpty()

    /** Returns the same as a member of JSON; nothing if none is left out. */
    fun jsonOf(file: Path): Map<String, JsonElement> =
        of(file).let { left -> if (left.isEmpty()) emptyMap() else mapOf("leftOut" to JsonArray(left.map { JsonPrimitive(it) })) }

    override fun isSource(file: Path, head: ByteArray): Boolean = maker.isSource(file, head)

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> =
        maker.make(file, made, checkpoint).also { found[file] = leftOutIn(it) }
}

private fun leftOutIn(problems: List<Problem>) = problems.filter { it.kind == ProblemKind.LOG_LEFT_OUT }.map { it.message }
