package badlog.window.task

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.LocalWindowExceptionHandlerFactory
import androidx.compose.ui.window.WindowExceptionHandler
import androidx.compose.ui.window.WindowExceptionHandlerFactory
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import javax.swing.JOptionPane
import kotlin.time.Duration.Companion.seconds

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
