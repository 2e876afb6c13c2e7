package badlog.window.task

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.LocalWindowExceptionHandlerFactory
import androidx.compose.ui.window.WindowExceptionHandler
import androidx.compose.ui.window.WindowExceptionHandlerFactory
import kotlinx.coroutines.CoroutineExceptionHandler
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.job
import kotlinx.coroutines.plus
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.time.LocalDateTime
import java.time.temporal.ChronoUnit
import javax.swing.JOptionPane
import javax.swing.SwingUtilities
import kotlin.time.Duration.Companion.seconds

/**
 * Receives uncaught exceptions, which are defects of badlog. They are written to [log] and reported in a sentence. The window stays open,
 * so that one failed click does not cost open work.
 */
internal class Failures(private val log: FailureLog, private val notices: Notices) {
    /** The number of failures. */
    var count by mutableIntStateOf(0)
        private set

    /** The number of failures that the window has shown: lower if it can no longer show anything. */
    var seen = 0

    /** The file that stores them. */
    val file: Path get() = log.file

    /** Receives [failure], on any thread. */
    fun handle(failure: Throwable) {
        val where = if (log.add(failure)) "; send us $file" else ""
        SwingUtilities.invokeLater {
            count++
            notices.complain("That failed (${failure.javaClass.simpleName})$where. Your logs are still open.")
        }
    }

    /** Returns [scope] with failures reported here, so that one does not cancel anything else. */
    fun guarded(scope: CoroutineScope): CoroutineScope =
        scope + SupervisorJob(scope.coroutineContext.job) + CoroutineExceptionHandler { _, failure -> handle(failure) }
}

/** The failures of the program itself, for its developers: written to [file], each once per run. Thread-safe. */
internal class FailureLog(cache: Path) {
    /** The file that stores them. */
    val file: Path = cache.resolve("failures.log")

    private val known = HashSet<String>()

    /** Adds [failure]. Returns whether it was written; false on a full disk, or after very many others. */
    @Synchronized
    fun add(failure: Throwable): Boolean {
        val trace = failure.stackTraceToString()
        if (trace in known) return true
        if (known.size >= MAX_KNOWN) return false
        try {
            Files.createDirectories(file.parent)
            if (Files.exists(file) && Files.size(file) > MAX_BYTES) Files.delete(file)
            Files.writeString(file, "${place()}\n$trace\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND)
        } catch (_: IOException) {
            return false
        }
        return known.add(trace)
    }

    private fun place(): String {
        val system = listOf("os.name", "os.version", "os.arch", "java.version").joinToString(" ") { System.getProperty(it) }
        return "${LocalDateTime.now().truncatedTo(ChronoUnit.SECONDS)} $system"
    }
}

/** Makes the windows of [content] report failures to [failures] rather than close. */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
internal fun FailureBoundary(failures: Failures, content: @Composable () -> Unit) {
    val factory = remember(failures) { WindowExceptionHandlerFactory { WindowExceptionHandler(failures::handle) } }
    CompositionLocalProvider(LocalWindowExceptionHandlerFactory provides factory, content = content)
}

/** Records in [failures] that the window is still updated. */
@Composable
internal fun FailuresSeen(failures: Failures) {
    val count = failures.count
    SideEffect { failures.seen = count }
}

/**
 * Ends the program if a failure has frozen the window's picture, as failures during composition do. Reports this if [failures] are not
 * shown although the window [isInSight], and then calls [end]. Suspends until cancelled.
 */
internal suspend fun endWhenStuck(failures: Failures, isInSight: () -> Boolean, end: () -> Unit) {
    snapshotFlow { failures.count }.collectLatest { count ->
        delay(PATIENCE)
        if (failures.seen >= count || !isInSight()) return@collectLatest
        val sentence = "badlog failed and has to close; start it again, and send us ${failures.file}."
        JOptionPane.showMessageDialog(null, sentence, "badlog", JOptionPane.ERROR_MESSAGE)
        end()
    }
}

private val PATIENCE = 3.seconds

/** The largest number of stored failures: a failure in each frame must not fill the disk. */
private const val MAX_KNOWN = 50
private const val MAX_BYTES = 1L shl 20
