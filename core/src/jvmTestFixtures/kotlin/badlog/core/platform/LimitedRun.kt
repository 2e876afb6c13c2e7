package badlog.core.platform

import java.io.File
import java.util.concurrent.TimeUnit

/** How a program ended: its exit code, and all that it printed. */
internal class LimitedRun(val code: Int, val text: String) {
    internal companion object {
        /** How long an emulated program may take: one that hangs must not hold up all others. */
        const val LIMIT_MINUTES = 2L

        /** Runs [command] in [folder], with [environment] added to this one's and [input] as its standard input; it is ended after [minutes]. */
        fun of(
            command: List<String>,
            environment: Map<String, String> = emptyMap(),
            folder: File = File("."),
            input: File? = null,
            minutes: Long = LIMIT_MINUTES,
        ): LimitedRun {
            // Not a pipe: what Wine leaves running would keep it open.
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
