package badlog.cli.doctor

import badlog.cli.Ended
import badlog.cli.badlogOn
import badlog.cli.command.ExitCode
import badlog.cli.computer.Computer
import badlog.cli.fetch.Robots
import badlog.cli.with
import badlog.exporter.BADLOG_VERSION
import badlog.fetch.Patience
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.div

class DoctorSpec : FunSpec({
    fun computer(folder: Path, variables: Map<String, String>, cache: Path = folder / ".cache/badlog") = Computer("Linux", folder, variables::get, UserFolders(folder / ".config/badlog", cache)) { true }

    fun Ended.states() = json.single().getValue("checks").jsonArray.map { it.jsonObject }.associate {
        it.getValue("name").jsonPrimitive.content to it.getValue("status").jsonPrimitive.content
    }

    fun robotsAt(port: Int) = Robots({ _, _ -> listOf(RobotAddress("127.0.0.1", emptyList(), port)) }, { error("not asked") }, null, Patience(Duration.ofSeconds(60)))

    test("found programs and folders are shown with their places and the size of the cache") {
        inFolder { folder ->
            for (name in listOf("xdg-open", "owlet", "badlog-window")) folder.with("bin/$name", "").toFile().setExecutable(true)
            folder.with(".cache/badlog/answers/a", "12345")
            folder.with(".cache/badlog/pages/b", "1234567")
            val computer = computer(folder, mapOf("PATH" to "${folder / "bin"}", Computer.WINDOW to "${folder / "bin/badlog-window"}"))
            val ended = badlogOn(computer, "doctor")
            ended.code shouldBe ExitCode.WHOLE
            val text = ended.out.replace(Regex("\\s+"), " ")
            text shouldContain "ok badlog $BADLOG_VERSION ok Java "
            for (name in listOf("xdg-open", "owlet", "badlog-window")) text shouldContain "${folder / "bin" / name}"
            text shouldContain "ok settings ${folder / ".config/badlog"}, not used yet"
            text shouldContain "ok cache ${folder / ".cache/badlog"}, 2 files, 12 bytes; safe to delete"
            badlogOn(computer, "doctor", "--json").states().values.toSet() shouldBe setOf("ok")
        }
    }

    test("a missing program is not a failure, but an unusable folder is") {
        inFolder { folder ->
            val ended = badlogOn(computer(folder, emptyMap()), "doctor", "--json")
            ended.code shouldBe ExitCode.WHOLE
            ended.states().filterValues { it != "ok" } shouldBe mapOf("browser" to "missing", "window" to "missing", "owlet" to "missing")
            val blocked = badlogOn(computer(folder, emptyMap(), cache = folder.with("file", "")), "doctor", "--json")
            blocked.code shouldBe ExitCode.SALVAGED
            blocked.states().getValue("cache") shouldBe "error"
        }
    }

    test("doctor looks for a named robot") {
        inFolder { folder ->
            val socket = ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))
            val found = socket.use { badlogOn(computer(folder, emptyMap()), "doctor", "1014", robots = robotsAt(it.localPort)) }
            found.out shouldContain "answers at 127.0.0.1:${socket.localPort}"
            val lost = badlogOn(computer(folder, emptyMap()), "doctor", "1014", robots = robotsAt(socket.localPort))
            lost.code shouldBe ExitCode.SALVAGED
            lost.out shouldContain "does not answer at 127.0.0.1:${socket.localPort}"
            badlogOn(computer(folder, emptyMap()), "doctor", "99999999").code shouldBe ExitCode.USAGE
        }
    }
})
