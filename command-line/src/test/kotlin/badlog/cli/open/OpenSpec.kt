package badlog.cli.open

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.Ended
import badlog.cli.badlogOn
import badlog.cli.command.ExitCode
import badlog.cli.computer.Computer
import badlog.cli.names
import badlog.cli.with
import badlog.files.UserFolders
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import kotlin.io.path.div
import kotlin.io.path.readText

/** A computer that only records the programs it should start; those named in [broken] fail. */
private class Desk(private val folder: Path, hasWindow: Boolean, private val broken: Set<String> = emptySet()) {
    val started = ArrayList<List<String>>()
    val window: Path = folder.with("window/badlog", "").also { it.toFile().setExecutable(true) }
    private val variables = if (hasWindow) mapOf(Computer.WINDOW to "$window") else emptyMap()
    private val computer = Computer("Linux", folder, variables::get, UserFolders(folder / "settings", folder / "cache")) { command ->
        started += command
        Path.of(command[0]).fileName.toString() !in broken
    }

    fun open(vararg arguments: Any, input: String = ""): Ended = badlogOn(computer, "open", *arguments, input = input.byteInputStream())
}

class OpenSpec : FunSpec({
    test("the window opens the named log or folder") {
        inFolder { folder ->
            val desk = Desk(folder, hasWindow = true)
            val log = folder.with("logs/a.bag", BAG)
            desk.open(log).out shouldBe "Opened $log in the window.\n"
            desk.open(log.parent).code shouldBe ExitCode.WHOLE
            desk.started shouldBe listOf(listOf("${desk.window}", "$log"), listOf("${desk.window}", "${log.parent}"))
        }
    }

    test("the window opens with the pit view, which no page replaces") {
        inFolder { folder ->
            val log = folder.with("logs/a.bag", BAG)
            val desk = Desk(folder, hasWindow = true)
            desk.open(log.parent, "--pit").code shouldBe ExitCode.WHOLE
            desk.started shouldBe listOf(listOf("${desk.window}", "${log.parent}", "--pit"))
            desk.open(log.parent, "--pit", "--page").code shouldBe ExitCode.USAGE
            val without = Desk(folder, hasWindow = false)
            without.open(log.parent, "--pit").err shouldContain "The pit view is a part of the window, which cannot be started"
            without.started.shouldBeEmpty()
        }
    }

    test("without the window, the page of the newest log opens in the browser, and no file is written beside the logs") {
        inFolder { folder ->
            val desk = Desk(folder, hasWindow = false)
            val logs = listOf("a.bag", "b.bag", "c.bag").map { folder.with("logs/$it", BAG) }
            for ((log, hour) in logs.zip(listOf(1L, 3L, 2L))) Files.setLastModifiedTime(log, FileTime.fromMillis(hour * 3_600_000))
            val ended = desk.open(folder / "logs")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldBe "Opened the page of ${logs[1]} in the browser.\n"
            ended.err shouldBe ""
            desk.started.single()[0] shouldBe "xdg-open"
            desk.started.single()[1] shouldEndWith "cache/pages/b.bag.html"
            (folder / "cache/pages/b.bag.html").readText() shouldContain "<!DOCTYPE html"
            (folder / "logs").names() shouldBe listOf("a.bag", "b.bag", "c.bag")
            desk.open(folder / "logs", "--json").json.single().getValue("opened").jsonPrimitive.content shouldBe "page"
        }
    }

    test("--page opens the page instead of the window, and so does a window that cannot be started") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val desk = Desk(folder, hasWindow = true, broken = setOf("badlog"))
            desk.open(log, "--page").err shouldBe ""
            desk.open(log).err shouldContain "cannot be started; opening the page instead"
            desk.started.map { Path.of(it[0]).fileName.toString() } shouldBe listOf("xdg-open", "badlog", "xdg-open")
        }
    }

    test("the standard input opens as a page that contains the log") {
        inFolder { folder ->
            val ended = Desk(folder, hasWindow = true).run { open("-", input = BAG).also { started.single()[0] shouldBe "xdg-open" } }
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldBe "Opened the page of standard input in the browser.\n"
            (folder / "cache/pages/stdin.html").readText() shouldContain "<!DOCTYPE html"
            Desk(folder, hasWindow = true).open("-", input = "hello\nworld\n").code shouldBe ExitCode.NOTHING
        }
    }

    test("--browser opens the page for other logs, and prints the folder to choose on it") {
        inFolder { folder ->
            val desk = Desk(folder, hasWindow = true)
            val page = folder / "cache/pages/badlog.html"
            desk.open("--browser").out shouldBe "Opened $page in the browser.\n"
            desk.open("--browser", folder).out shouldBe "Opened $page in the browser. Choose or drop $folder there.\n"
            desk.started.map { it[1] }.distinct() shouldBe listOf(page.toUri().toString())
            page.readText() shouldContain "<title>badlog</title>"
            desk.open().code shouldBe ExitCode.USAGE
            Desk(folder, hasWindow = true, broken = setOf("xdg-open")).open("--browser").err shouldContain "No browser can be started; open $page yourself."
        }
    }

    test("files that cannot be opened are reported, and a damaged log opens") {
        inFolder { folder ->
            val desk = Desk(folder, hasWindow = false, broken = setOf("xdg-open"))
            desk.open(folder / "none.bag").err shouldContain "There is no file or folder"
            desk.open((folder / "empty").also { Files.createDirectory(it) }).err shouldContain "No logs found"
            desk.open(folder.with("a.txt", "hello\nworld\n")).code shouldBe ExitCode.NOTHING
            desk.started.shouldBeEmpty()
            val ended = desk.open(folder.with("a.bag", BAG))
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "No browser can be started; open ${folder / "cache/pages/a.bag.html"} yourself."
            Desk(folder, hasWindow = false).open(folder.with("cut.bag", CUT_BAG)).code shouldBe ExitCode.SALVAGED
            desk.open(folder, folder).code shouldBe ExitCode.USAGE
        }
    }
})
