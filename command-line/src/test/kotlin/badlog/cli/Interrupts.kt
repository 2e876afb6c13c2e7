package badlog.cli

import io.kotest.core.test.Enabled
import java.io.File

/** For tests that end a program as Ctrl+C does. */
internal val IF_INTERRUPTS: Enabled = when {
    File.separatorChar != '/' -> Enabled.disabled("Windows has no signals that one program could send to another")
    isInterruptIgnored() -> Enabled.disabled("this build runs in the background of a shell, whose programs ignore SIGINT; so do those they start")
    else -> Enabled.enabled
}

/** Sends [process] the signal of Ctrl+C. */
internal fun interrupt(process: Process) {
    check(ProcessBuilder("kill", "-INT", "${process.pid()}").inheritIO().start().waitFor() == 0) { "SIGINT could not be sent." }
}

/** For tests that end a program so that it can still do something. */
internal val IF_ENDED_GENTLY: Enabled =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows ends a program of another without a signal")

/** Ends [process] as Ctrl+C does, or where that is ignored by SIGTERM, to which Java does the same. */
internal fun endGently(process: Process) = if (isInterruptIgnored()) process.destroy() else interrupt(process)

/** Whether programs started here ignore SIGINT. False if the system does not say so; only Linux does. */
private fun isInterruptIgnored(): Boolean {
    val status = File("/proc/self/status").takeIf { it.canRead() } ?: return false
    val ignored = status.readLines().firstOrNull { it.startsWith("SigIgn:") }?.substringAfter(':')?.trim() ?: return false
    return ignored.toULong(radix = 16) and SIGINT_BIT != 0uL
}

/** SIGINT is signal 2; signal 1 has the lowest bit. */
private const val SIGINT_BIT = 2uL
