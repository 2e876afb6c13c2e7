package badlog.viewer.failure

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.app.Notices
import kotlinx.coroutines.CoroutineExceptionHandler
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.job
import kotlinx.coroutines.plus
import java.nio.file.Path
import javax.swing.SwingUtilities

/**
 * Hears of what nobody else has caught, defects of ours. They are kept in [log] and said in a sentence, and the window goes on: a
 * person must not lose what is open because of one click that did not work.
 */
internal class Failures(private val log: FailureLog, private val notices: Notices) {
    /** How many there were. */
    var count by mutableIntStateOf(0)
        private set

    /** Of how many the window has shown that it knows: fewer when it can show nothing any more. */
    var seen = 0

    /** Where they are kept. */
    val file: Path get() = log.file

    /** Hears of [failure]; on any thread. */
    fun hear(failure: Throwable) {
        val where = if (log.add(failure)) "; please send us $file" else ""
        SwingUtilities.invokeLater {
            count++
            notices.complain("That made badlog stumble (${failure.javaClass.simpleName})$where. What is open stays open.")
        }
    }

    /** [scope], but what fails in it ends nothing else, and is heard here. */
    fun guarded(scope: CoroutineScope): CoroutineScope =
        scope + SupervisorJob(scope.coroutineContext.job) + CoroutineExceptionHandler { _, failure -> hear(failure) }
}
