package badlog.core.platform

import java.io.File
import java.util.concurrent.TimeUnit

/** The end of a program: its exit code, and all of its output. */
internal class LimitedRun(val code: Int, val text: String) {
    internal companion object {
        /** The time limit of an emulated program: one that hangs must not delay all others. */
        const val LIMIT_MINUTES = 2L

        /** Runs [command] in [folder], with [environment] added to this one's, and [input] as standard input. Ends it after [minutes]. */
        fun of(
            command: List<String>,
            environment: Map<String, String> = emptyMap(),
            folder: File = File("."),
            input: File? = null,
            minutes: Long = LIMIT_MINUTES,
        ): LimitedRun {
            // Not a pipe, because processes that Wine leaves running would keep it open.
            val output = File.createTempFile("badlog-output", ".txt")
            try {
                val builder = ProcessBuilder(command).directory(folder).redirectErrorStream(true).redirectOutput(output)
                builder.environment() += environment
                if (input != null) builder.redirectInput(input)
                val process = builder.start()
                if (input == null) process.outputStream.close()
                val hasEnded = process.waitFor(minutes, TimeUnit.MINUTES)
                if (!hasEnded) {
                    process.descendants().forEach { it.destroyForcibly() }
                    process.destroyForcibly().waitFor()
                }
                val text = output.readText()
                check(hasEnded) { "${command.joinToString(" ")} has not ended after $minutes minutes. It said: $text" }
                return LimitedRun(process.exitValue(), text)
            } finally {
                output.delete()
            }
        }
    }
}
