package badlog.window.task

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.produceState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import kotlinx.coroutines.delay

/**
 * The lines at the bottom of the window: running tasks, and notices of successes and failures.
 *
 * @param isWaiting whether the chosen state is still being calculated.
 */
@Composable
internal fun StatusLines(notices: Notices, tasks: LongTasks, isWaiting: Boolean) {
    // Most calculations end before a person could read that.
    val isLong by produceState(false, isWaiting) {
        value = false
        if (isWaiting) delay(PATIENCE_MILLIS)
        value = isWaiting
    }
    Column(Modifier.fillMaxWidth()) {
        if (isLong) Progress("Calculating what is shown", share = null)
        for (notice in notices.all) key(notice.id) { NoticeLine(notice) { notices.dismiss(notice.id) } }
        for (task in tasks.all) key(task.id) { TaskLine(task) }
    }
}

@Composable
private fun NoticeLine(notice: Notice, onDismiss: () -> Unit) {
    val palette = LocalPalette.current
    if (!notice.isError) {
        LaunchedEffect(notice.id) {
            delay(if (notice.action == null) SAID_MILLIS else OFFERED_MILLIS)
            onDismiss()
        }
    }
    Row(
        Modifier
            .fillMaxWidth()
            .background(if (notice.isError) palette.errorSoft else palette.accentSoft)
            .padding(start = 12.dp, end = 4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(
            notice.text,
            Modifier.weight(1f).padding(vertical = 4.dp).semantics { liveRegion = LiveRegionMode.Polite },
            color = if (notice.isError) palette.error else palette.text,
        )
        notice.action?.let { action ->
            ToolButton(action.label, text = action.label) {
                action.run()
                onDismiss()
            }
        }
        ToolButton("Dismiss", Icons.Close, onClick = onDismiss)
    }
}

@Composable
private fun TaskLine(task: LongTask) = Progress(task.title, task.share) {
    ToolButton("Cancel: ${task.title}", text = "Cancel", onClick = task.cancel)
}

@Composable
private fun Progress(title: String, share: Float?, cancel: @Composable () -> Unit = {}) {
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(start = 12.dp, end = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(title, Modifier.weight(1f), maxLines = 1)
        if (share == null) {
            LinearProgressIndicator(Modifier.width(160.dp))
        } else {
            LinearProgressIndicator(progress = { share }, modifier = Modifier.width(160.dp))
        }
        cancel()
    }
}

private const val PATIENCE_MILLIS = 500L
private const val SAID_MILLIS = 6000L
private const val OFFERED_MILLIS = 30_000L
