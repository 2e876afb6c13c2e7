package badlog.window.robot

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.theme.rememberAskedFocus

/** The connection to a robot: its address, its status, its questions, and its recording. */
@Composable
internal fun RobotBar(link: RobotLink, recording: RobotRecording, settings: SettingsStore) {
    val state = link.state
    if (!state.isShown) return
    val robot = settings.state.robot
    Column(Modifier.fillMaxWidth().padding(start = 8.dp, end = 8.dp, bottom = 6.dp), verticalArrangement = Arrangement.spacedBy(4.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            val focus = rememberAskedFocus(state.isAsked) { link.change { copy(isAsked = false) } }
            val keyboard = LocalFocusManager.current
            val onEnter = Modifier.weight(1f).focusRequester(focus).entering {
                if (robot.isNotBlank()) {
                    link.connect(robot)
                    // From here on, keys are commands again.
                    keyboard.clearFocus()
                }
            }
            SearchField(robot, "Team number or address", onEnter, Icons.Robot, keepsText = true, isSelectedAtFirst = true) { typed ->
                settings.change { copy(robot = typed) }
            }
            if (state.isOn) {
                ToolButton("Disconnect from the robot", text = "Disconnect") { link.disconnect() }
            } else {
                ToolButton("Fetch logs from the robot", text = "Fetch", isEnabled = robot.isNotBlank()) { link.connect(robot) }
            }
            RecordMenu(recording, robot)
        }
        if (state.status.isNotEmpty() && state.question == null) RobotStatus(state) { link.connect(robot, anyway = true) }
        state.question?.let { question -> if (question.isPassword) PasswordLine(question) else TrustLine(question) }
    }
}

/** The button for recording the data that [robot] publishes, which needs no logs and no code there. */
@Composable
private fun RecordMenu(recording: RobotRecording, robot: String) {
    if (recording.state.isOn) return ToolButton("Stop recording the robot", text = "Stop") { recording.stop() }
    var isOpen by remember { mutableStateOf(false) }
    val lines = @Composable {
        MenuLine("Record until stopped") {
            isOpen = false
            recording.start(robot, isPerEnable = false)
        }
        MenuLine("Record a log each time the robot is enabled") {
            isOpen = false
            recording.start(robot, isPerEnable = true)
        }
        MenuLine("Also record Systemcore and the Driver Station (2027)", Icons.Check.takeIf { recording.state.isOfAll }) {
            recording.toggleAll()
        }
    }
    MenuBox(isOpen, { isOpen = false }, menu = lines) {
        ToolButton("Record what the robot publishes", text = "Record", isOn = isOpen, isEnabled = robot.isNotBlank()) { isOpen = !isOpen }
    }
}

@Composable
private fun RobotStatus(state: RobotLinkState, onAnyway: () -> Unit) {
    val palette = LocalPalette.current
    Text(
        state.coming?.let { "Copying ${it.name}" } ?: state.status,
        Modifier.padding(horizontal = 4.dp).semantics { liveRegion = LiveRegionMode.Polite },
        color = if (state.isTrouble) palette.warning else palette.muted,
        fontSize = 12.sp,
        lineHeight = 16.sp,
        maxLines = 5,
        overflow = TextOverflow.Ellipsis,
    )
    if (state.mayBeEnabled) ToolButton("Fetch even if the robot may be enabled", text = "Fetch anyway", onClick = onAnyway)
    state.coming?.let { coming ->
        LinearProgressIndicator(
            progress = { coming.share },
            modifier = Modifier.fillMaxWidth().height(2.dp),
            gapSize = 0.dp,
            drawStopIndicator = {},
        )
    }
}

@Composable
private fun TrustLine(question: RobotQuestion) {
    Text(question.text, Modifier.padding(horizontal = 4.dp), fontSize = 12.sp, lineHeight = 16.sp)
    Row {
        ToolButton("Trust this robot", text = "Trust") { question.answer("") }
        ToolButton("Do not trust this robot", text = "Don’t trust") { question.answer(null) }
    }
}

@Composable
private fun PasswordLine(question: RobotQuestion) {
    // The password is stored only here: it disappears with the question.
    var typed by remember(question) { mutableStateOf("") }
    val onEnter = Modifier.fillMaxWidth().entering { question.answer(typed) }
    SearchField(typed, question.text, onEnter, Icons.Robot, isSecret = true) { typed = it }
    Row {
        ToolButton("Log into the robot", text = "Log in") { question.answer(typed) }
        ToolButton("Do not log in", text = "Cancel") { question.answer(null) }
    }
}

private fun Modifier.entering(action: () -> Unit) = onPreviewKeyEvent {
    val isEnter = it.type == KeyEventType.KeyDown && (it.key == Key.Enter || it.key == Key.NumPadEnter)
    if (isEnter) action()
    isEnter
}

/** The line at the bottom of the window while it records: log, amount of data, and connection to the robot. */
@Composable
internal fun RecordingLine(recording: RobotRecording) {
    val state = recording.state
    if (!state.isOn) return
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth().background(palette.surface).padding(start = 12.dp, end = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(10.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Box(Modifier.size(9.dp).background(if (state.file == null) palette.muted else palette.error, CircleShape))
        // The amount changes too often to be spoken.
        if (state.file != null) Text(state.amount, maxLines = 1, softWrap = false)
        Text(
            listOfNotNull(state.waiting, state.connection).joinToString(" "),
            Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite },
            color = palette.muted,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        ToolButton("Stop recording", text = "Stop recording") { recording.stop() }
    }
}
