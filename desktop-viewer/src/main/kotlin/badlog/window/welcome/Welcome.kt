package badlog.window.welcome

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.formats.READABLE_LOGS
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/**
 * A person's actions while no log is open.
 *
 * @property openSample shows the match that comes with the window.
 * @property askForFolder asks for a folder of logs and opens it.
 * @property askForLog asks for a log and opens it.
 * @property askForRobot asks for the robot to copy logs from, and first for a folder if there is none yet.
 */
internal class WelcomeActions(
    val openSample: () -> Unit,
    val askForFolder: () -> Unit,
    val askForLog: () -> Unit,
    val askForRobot: () -> Unit,
)

/** The content of the window while no log is open: the ways to get one. */
@Composable
internal fun Welcome(actions: WelcomeActions, modifier: Modifier = Modifier) {
    val scroll = rememberScrollState()
    BoxWithConstraints(modifier.semantics { contentDescription = "Welcome" }) {
        val isWide = maxWidth >= WIDE
        Column(
            Modifier.fillMaxSize().verticalScroll(scroll).padding(horizontal = 16.dp, vertical = 20.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
            horizontalAlignment = Alignment.CenterHorizontally,
        ) {
            Text(
                "Welcome to badlog",
                Modifier.semantics {
                    heading()
                },
                fontSize = 20.sp,
                lineHeight = 26.sp,
                fontWeight = FontWeight.SemiBold,
            )
            Text("See what your robot did, and why.", Modifier.padding(bottom = 4.dp), color = LocalPalette.current.muted)
            if (isWide) {
                Row(Modifier.widthIn(max = WIDEST).height(IntrinsicSize.Min), horizontalArrangement = Arrangement.spacedBy(12.dp)) {
                    val part = Modifier.weight(1f).fillMaxHeight()
                    SampleCard(actions, part)
                    OwnLogsCard(actions, part)
                    RobotCard(actions, part)
                }
            } else {
                val part = Modifier.fillMaxWidth()
                SampleCard(actions, part)
                OwnLogsCard(actions, part)
                RobotCard(actions, part)
            }
            Card(
                "Log on a robot",
                "A few lines in the robot’s program, which then writes one log per match.",
                Modifier.widthIn(max = WIDEST).fillMaxWidth(),
            ) {
                LoggingLines(isWide)
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(scroll), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

@Composable
private fun SampleCard(actions: WelcomeActions, modifier: Modifier) = Card(
    "Try a sample",
    "Qualification 42, in which the robot lost power. Press N there to go from finding to finding.",
    modifier,
) {
    ToolButton("Open the sample match", Icons.Graph, text = "Open sample", isOn = true, onClick = actions.openSample)
}

@Composable
private fun OwnLogsCard(actions: WelcomeActions, modifier: Modifier) = Card(
    "Open your logs",
    "Or drop a folder or files here: $READABLE_LOGS.",
    modifier,
) {
    ToolButton("Open a folder of your logs", Icons.Folder, text = "Open folder…", isOn = true, onClick = actions.askForFolder)
    ToolButton("Open one of your logs", text = "Open file…", isOn = true, onClick = actions.askForLog)
}

@Composable
private fun RobotCard(actions: WelcomeActions, modifier: Modifier) = Card(
    "Fetch logs",
    "Connect this computer to the robot’s network; new logs are then copied into a folder, match after match.",
    modifier,
) {
    ToolButton("Fetch logs from a robot", Icons.Robot, text = "From a robot…", isOn = true, onClick = actions.askForRobot)
}

/** A framed part of the welcome: its purpose, and below that its actions. */
@Composable
private fun Card(title: String, text: String, modifier: Modifier, content: @Composable () -> Unit) {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(8.dp)
    Column(
        modifier.background(palette.surface, shape).border(1.dp, palette.border, shape).padding(14.dp),
        verticalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        Text(title, Modifier.semantics { heading() }, fontSize = 15.sp, fontWeight = FontWeight.SemiBold)
        Text(text, color = palette.muted)
        Column(Modifier.padding(top = 2.dp), verticalArrangement = Arrangement.spacedBy(6.dp)) { content() }
    }
}

/** The smallest width at which the cards are side by side. */
private val WIDE = 560.dp
private val WIDEST = 860.dp
