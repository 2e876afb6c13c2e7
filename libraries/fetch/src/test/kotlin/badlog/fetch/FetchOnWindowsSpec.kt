package badlog.fetch

import badlog.files.UnwritableFileException
import badlog.files.windows.WindowsFiles
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.Files
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlin.io.path.writeText

private const val Q1 = "MILLC/match Qualification 1.bag"

@Tags("InCheck")
class FetchOnWindowsSpec : FunSpec({
    fun inWindowsPit(work: (Pit, WindowsFiles, FakeRobot) -> Unit) {
        val disk = Files.createTempDirectory("badlog")
        try {
            WindowsFiles().use { windows ->
                FakeRobot(disk).use { robot -> work(Pit(windows.folder), windows, robot) }
                windows.openCount shouldBe 0
            }
        } finally {
            disk.toFile().deleteRecursively()
        }
    }

    test("logs with names that Windows refuses, changes or reserves get ordinary names") {
        inWindowsPit { pit, _, robot ->
            for (name in listOf("NUL.bag", "com1.csv", "a:b.csv", "what?.csv", " x .csv")) robot.log(name, "a,b\n${name.length},2\n")
            robot.log("CON.wpilog", matchBag(7).replace("MILLC", "AUX"))
            pit.fetch(robot).fetched.size shouldBe 6
            val refused = Regex("""(?i)(con|prn|aux|nul|com\d|lpt\d)( *\..*)?|.*[<>:"|?*\\].*|.*[. ]|""")
            pit.logs().flatMap { it.split('/') }.filter(refused::matches).shouldBeEmpty()
            pit.logs().size shouldBe 6
            pit.parts().shouldBeEmpty()
        }
    }

    test("a log that has grown replaces its copy only once no other program has that open") {
        inWindowsPit { pit, windows, robot ->
            robot.log("match.bag", matchBag(1, rows = 2000))
            pit.fetch(robot)
            robot.log("match.bag", matchBag(1, rows = 3000), secondsAgo = 50)
            val copy = pit.folder / Q1
            windows.whileOpen(copy) {
                shouldThrow<UnwritableFileException> { pit.fetch(robot) }.message shouldStartWith "$copy cannot be written"
                copy.readText() shouldBe matchBag(1, rows = 2000)
                pit.parts().size shouldBe 1
            }
            val served = robot.servedBytes
            pit.fetch(robot).fetched.single().resumedAt shouldBe matchBag(1, rows = 3000).length.toLong()
            (robot.servedBytes - served < matchBag(1, rows = 3000).length) shouldBe true
            copy.readText() shouldBe matchBag(1, rows = 3000)
            pit.logs() shouldContainExactly listOf(Q1)
            pit.parts().shouldBeEmpty()
        }
    }

    test("a read-only copy stays, and is reported in one sentence") {
        inWindowsPit { pit, windows, robot ->
            robot.log("match.bag", matchBag(1, rows = 2000))
            pit.fetch(robot)
            robot.log("match.bag", matchBag(1, rows = 3000), secondsAgo = 50)
            val copy = pit.folder / Q1
            windows.protect(copy)
            shouldThrow<UnwritableFileException> { pit.fetch(robot) }.message shouldBe
                "$copy cannot be replaced: it is read-only, or another program has it open; make it writable, or close it there."
            copy.readText() shouldBe matchBag(1, rows = 2000)
        }
    }

    test("unreadable logs, logs of a match that has one already, and the list of fetched logs are written as elsewhere") {
        inWindowsPit { pit, _, robot ->
            Files.createDirectories(pit.folder / "MILLC")
            (pit.folder / Q1).writeText("somebody's own")
            robot.log("match.bag", matchBag(1))
            robot.log("broken.bag", "\u0000\u0000")
            pit.fetch(robot).fetched.size shouldBe 2
            pit.logs() shouldContainExactly listOf("MILLC/match Qualification 1 (2).bag", Q1, "broken.bag")
            pit.fetch(robot).fetched.shouldBeEmpty()
        }
    }
})
