package badlog.window.robot

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.fetch.DriverStation
import badlog.fetch.FakeRobot
import badlog.fetch.RobotAddress
import badlog.fetch.matchBag
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.waiting.waitFor
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.io.path.readText

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class RobotBarSpec : FunSpec({
    fun beside(addresses: (String) -> List<RobotAddress>, folder: Path, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home), robots = addresses)
        runDesktopComposeUiTest(1600, 800) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.newest.run() }
            viewer.library.open(folder)
            waitFor { viewer.library.state.hasLooked }
            onNodeWithContentDescription("Logs from the robot").performClick()
            try {
                steps(viewer)
            } finally {
                viewer.robot.disconnect()
                viewer.library.close()
            }
        }
    }

    fun DesktopComposeUiTest.connect() {
        onNodeWithContentDescription("Team number or address").performTextInput("1014")
        onNodeWithContentDescription("Team number or address").performKeyInput { pressKey(Key.Enter) }
    }

    fun DesktopComposeUiTest.awaitText(text: String) = waitFor { onAllNodes(hasText(text, substring = true)).fetchSemanticsNodes().isNotEmpty() }

    test("a team's number fetches new logs while the robot is disabled, and shows its newest match") {
        DriverStation().use { station ->
            FakeRobot(tempdir().toPath()).use { robot ->
                robot.log("match.bag", matchBag(42), secondsAgo = 100)
                robot.log("before.bag", matchBag(41), secondsAgo = 900)
                station.isEnabled = true
                beside({ listOf(robot.address(station.port)) }, tempdir().toPath()) { viewer ->
                    connect()
                    awaitText("10.10.14.2 is enabled; its logs are copied when it is disabled.")
                    station.isEnabled = false
                    awaitText("The robot at 10.10.14.2 is unknown. Its key is SHA256:")
                    onNodeWithContentDescription("Trust this robot").performClick()
                    waitForNotice(viewer, "2 logs came from 10.10.14.2, the newest is MILLC Qualification 42.")
                    waitFor { viewer.current.recording?.file?.fileName.toString().endsWith("Qualification 42.bag") || viewer.library.state.entries.size == 2 }
                    awaitText("nothing new, 2 logs fetched.")
                    viewer.settings.state.robot shouldBe "1014"
                    onNodeWithContentDescription("Disconnect from the robot").performClick()
                    viewer.robot.state.isOn shouldBe false
                }
            }
        }
    }

    test("the folder of the robot's logs is reported when another one is opened, and can be changed") {
        val first = tempdir().toPath()
        val second = tempdir().toPath()
        FakeRobot(tempdir().toPath()).use { robot ->
            beside({ listOf(robot.address()) }, first) { viewer ->
                viewer.scope.launch { viewer.robot.run() }
                connect()
                waitFor { viewer.robot.state.isOn }
                viewer.library.open(second)
                waitForNotice(viewer, "The robot’s logs still go into $first.")
                viewer.notices.all.last().action?.run?.invoke()
                viewer.library.open(first)
                waitForNotice(viewer, "The robot’s logs still go into $second.")
            }
        }
    }

    test("a password is requested, not shown, and not stored") {
        val folder = tempdir().toPath()
        FakeRobot(tempdir().toPath(), passwords = mapOf("lvuser" to "secret")).use { robot ->
            robot.log("match.bag", matchBag(42))
            DriverStation().use { station ->
                beside({ listOf(robot.address(station.port)) }, folder) { viewer ->
                    connect()
                    awaitText("Trust it?")
                    onNodeWithContentDescription("Trust this robot").performClick()
                    waitFor { viewer.robot.state.question?.isPassword == true }
                    onNodeWithContentDescription("Password of lvuser at 10.10.14.2").performTextInput("secret")
                    onNodeWithContentDescription("Password of lvuser at 10.10.14.2").assert(SemanticsMatcher.keyIsDefined(SemanticsProperties.Password))
                    onNodeWithContentDescription("Log into the robot").performClick()
                    waitForNotice(viewer, "MILLC Qualification 42 came from 10.10.14.2.")
                    folder.resolve(".badlog-fetched.jsonl").readText() shouldNotContain "secret"
                }
            }
        }
    }

    test("the field has the keyboard focus whenever it opens, and typed text replaces the last robot") {
        beside(RobotAddress::of, tempdir().toPath()) { viewer ->
            onNodeWithContentDescription("Team number or address").assertIsFocused()
            onNodeWithContentDescription("Team number or address").performTextInput("1014")
            repeat(2) { onNodeWithContentDescription("Logs from the robot").performClick() }
            onNodeWithContentDescription("Team number or address").assertIsFocused()
            onNodeWithContentDescription("Team number or address").performTextInput("254")
            runOnIdle { viewer.settings.state.robot shouldBe "254" }
            onNodeWithContentDescription("Team number or address").performTextInput("1")
            runOnIdle { viewer.settings.state.robot shouldBe "2541" }
        }
    }

    test("an invalid team or address is reported in one sentence, and so is a window without a folder") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        viewer.robot.connect("1014")
        viewer.robot.state.status shouldBe "First open the folder for the robot’s logs."
        beside(RobotAddress::of, tempdir().toPath()) {
            it.robot.connect("a b")
            it.robot.state.status shouldBe "“a b” is neither a team number nor an address; type 1014, 10.10.14.2 or user@robot.local."
            it.robot.state.isOn shouldBe false
        }
    }
})
