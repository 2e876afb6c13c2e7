package badlog.window.screen

import badlog.catalog.folder.putSamples
import badlog.catalog.folder.samples
import badlog.fetch.DriverStation
import badlog.fetch.FakeRobot
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.nio.file.Files
import kotlin.io.path.readBytes

class RobotWindowSpec : FunSpec({
    test("the logs of a robot come into the list, and the connection says how it stands").config(enabledOrReasonIf = { needsDisplay }) {
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek"))
        DriverStation().use { station ->
            FakeRobot(tempdir().toPath()).use { robot ->
                for (name in listOf("qualification-42.bag", "practice.bag")) robot.log(name, samples.resolve(name).readBytes())
                RealWindow(tempdir().toPath(), folder, robots = { listOf(robot.address(station.port)) }).use { window ->
                    window.awaitState("a look at the folder") { it.library.state.hasLooked }
                    window.click("Logs from the robot")
                    window.look { viewer -> viewer.settings.change { copy(robot = "1014") } }
                    window.click("Fetch logs from the robot")
                    window.awaitText("Trust this robot")
                    window.picture("robot-question")
                    window.click("Trust this robot")
                    window.awaitState("both logs, and one of them shown") { it.library.state.entries.size == 2 && it.current.recording != null }
                    window.awaitState("nothing new") { "nothing new" in it.robot.state.status }
                    window.awaitGraphs()
                    window.picture("robot")
                }
            }
        }
    }
})
