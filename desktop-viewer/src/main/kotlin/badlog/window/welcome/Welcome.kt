package badlog.window.welcome

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.horizontalScroll
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
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.formats.READABLE_LOGS
import badlog.window.folder.LogOpener
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The content of the window while no log is open: the ways to get one. */
@Composable
internal fun Welcome(opener: LogOpener, openSample: () -> Unit, askForRobot: () -> Unit, modifier: Modifier = Modifier) {
    val cards = @Composable { part: Modifier ->
        SampleCard(openSample, part)
        OwnLogsCard(opener, part)
        RobotCard(askForRobot, part)
    }
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
                Modifier.semantics { heading() },
                fontSize = 20.sp,
                lineHeight = 26.sp,
                fontWeight = FontWeight.SemiBold,
            )
            Text("See what your robot did, and why.", Modifier.padding(bottom = 4.dp), color = LocalPalette.current.muted)
            if (isWide) {
                Row(Modifier.widthIn(max = WIDEST).height(IntrinsicSize.Min), horizontalArrangement = Arrangement.spacedBy(12.dp)) {
                    cards(Modifier.weight(1f).fillMaxHeight())
                }
            } else {
                cards(Modifier.fillMaxWidth())
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
private fun SampleCard(openSample: () -> Unit, modifier: Modifier) = Card(
    "Try a sample",
    "Qualification 42, in which the robot lost power. Press N there to go from finding to finding.",
    modifier,
) {
    ToolButton("Open the sample match", Icons.Graph, text = "Open sample", isOn = true, onClick = openSample)
}

@Composable
private fun OwnLogsCard(opener: LogOpener, modifier: Modifier) = Card(
    "Open your logs",
    "Or drop a folder or files here: $READABLE_LOGS.",
    modifier,
) {
    ToolButton("Open a folder of your logs", Icons.Folder, text = "Open folder…", isOn = true, onClick = { opener.askForFolder() })
    ToolButton("Open one of your logs", text = "Open file…", isOn = true, onClick = opener::askForLog)
}

@Composable
private fun RobotCard(askForRobot: () -> Unit, modifier: Modifier) = Card(
    "Fetch logs",
    "Connect this computer to the robot’s network; new logs are then copied into a folder, match after match.",
    modifier,
) {
    ToolButton("Fetch logs from a robot", Icons.Robot, text = "From a robot…", isOn = true, onClick = askForRobot)
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

/** The code that makes a robot's program log, in the selected language; [isWide] if there is room beside the lines. */
@Composable
internal fun LoggingLines(isWide: Boolean) {
    var language by remember { mutableStateOf(LoggingLanguage.JAVA) }
    Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
        Row(horizontalArrangement = Arrangement.spacedBy(4.dp)) {
            for (one in LoggingLanguage.entries) {
                ToolButton("Show the lines in ${one.title}", text = one.title, isOn = one == language) { language = one }
            }
        }
        for ((place, code) in language.lines) {
            if (isWide) {
                Row {
                    Place(place, Modifier.width(140.dp).padding(vertical = 4.dp))
                    Code(code, Modifier.weight(1f))
                }
            } else {
                Column {
                    Place(place, Modifier)
                    Code(code, Modifier.fillMaxWidth())
                }
            }
        }
        Text(
            "How to install the logger, and what else it does: the guide docs/${language.guide}, also in the download badlog-docs.",
            color = LocalPalette.current.muted,
            fontSize = 12.sp,
            lineHeight = 16.sp,
        )
    }
}

@Composable
private fun Place(text: String, modifier: Modifier) = Text(text, modifier, color = LocalPalette.current.muted, fontSize = 12.sp)

@Composable
private fun Code(code: String, modifier: Modifier) = SelectionContainer(modifier) {
    Text(
        code,
        Modifier
            .background(LocalPalette.current.raised, RoundedCornerShape(4.dp))
            .horizontalScroll(rememberScrollState())
            .padding(horizontal = 8.dp, vertical = 4.dp),
        fontFamily = FontFamily.Monospace,
        fontSize = 12.sp,
        softWrap = false,
    )
}

/**
 * A language that robots log in.
 *
 * @property lines the code, by the place where it belongs. Each line is also in the program in the [guide], which that guide's tests
 * compile and run.
 * @property guide the guide with the rest, in the folder docs.
 */
internal enum class LoggingLanguage(val title: String, val guide: String, val lines: List<Pair<String, String>>) {
    JAVA(
        "Java",
        "robot.md",
        listOf(
            "In the class" to "private final RobotLog log = RobotLog.start();",
            "In the constructor" to """BadLog.createTopicDouble("Arm/Angle", "deg", () -> angle, "join:Arm/Position");""",
            "In robotPeriodic()" to "log.periodic();",
        ),
    ),
    KOTLIN(
        "Kotlin",
        "robot.md",
        listOf(
            "In the class" to "private val log = RobotLog.start(RobotLogOptions().apply { isCompressed = true })",
            "In init" to """BadLog.createTopicDouble("Arm/Angle", "deg", { angle }, "join:Arm/Position")""",
            "In robotPeriodic()" to "log.periodic()",
        ),
    ),
    CPP(
        "C++",
        "robot-cpp.md",
        listOf(
            "In the class" to """badlog::BadLog log = badlog::BadLog::Init(badlog::BadLog::FreePath("/home/lvuser/logs/robot.bag"));""",
            "In the constructor" to
                """
                badlog::BadLog::CreateTopic("Time", "s", [] { return frc::Timer::GetFPGATimestamp().value(); }, {"xaxis", "hide"});
                badlog::BadLog::CreateTopic("Arm/Angle", "deg", [this] { return angle; }, {"join:Arm/Position"});
                log.FinishInitialization();
                """.trimIndent(),
            "In RobotPeriodic()" to "log.UpdateTopics();\nlog.Log();",
        ),
    ),
    PYTHON(
        "Python",
        "python.md",
        listOf(
            "In robotInit()" to
                """
                self.log = BadLog.init("/home/lvuser/logs/match.bag")
                BadLog.create_topic("Time", "s", wpilib.Timer.getFPGATimestamp, "xaxis", "hide")
                BadLog.create_topic("Arm/Angle", "deg", lambda: self.angle, "join:Arm/Position")
                self.log.finish_initialization()
                """.trimIndent(),
            "In robotPeriodic()" to "self.log.update_topics()\nself.log.log()",
        ),
    ),
}
