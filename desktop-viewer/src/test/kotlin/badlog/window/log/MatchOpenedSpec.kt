package badlog.window.log

import badlog.exporter.additionsIn
import badlog.files.NotReadException
import badlog.window.choice.stationBeside
import badlog.window.export.Additions
import badlog.window.export.PageJob
import badlog.window.export.armBag
import badlog.window.export.makePages
import badlog.window.putPair
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

class MatchOpenedSpec : FunSpec({
    /** Puts the ZIP `match.zip` of a pair of logs into a new folder. */
    fun putZip(): Path {
        val pair = tempdir().toPath().also(::putPair)
        return tempdir().toPath().resolve("match.zip").toAbsolutePath().also { file ->
            ZipOutputStream(Files.newOutputStream(file)).use { zip ->
                for (log in Files.list(pair).use { it.sorted().toList() }) {
                    zip.putNextEntry(ZipEntry("${log.fileName}"))
                    Files.copy(log, zip)
                    zip.closeEntry()
                }
            }
        }
    }

    test("a ZIP of the logs of a match opens as one log, and needs no other Driver Station log") {
        val zip = putZip()
        val open = OpenRecording.read(zip)
        open.signals.map { it.name } shouldContainAll listOf("Arm/Angle", "Driver Station/Battery Voltage")
        putPair(zip.parent)
        // The robot's log alone gets the same log from the folder.
        stationBeside(OpenRecording.read(zip.resolveSibling("robot.bag")), null).shouldNotBeNull()
        stationBeside(open, null).shouldBeNull()
    }

    test("pages show a ZIP of a match, and compare with one") {
        val zip = putZip()
        val other = Files.writeString(zip.resolveSibling("a.bag"), armBag(100))
        val jobs = listOf(PageJob(zip, zip.resolveSibling("zip.html")), PageJob(other, zip.resolveSibling("a.html"), listOf(zip)))
        val pages = makePages(jobs, Additions(emptyList(), listOf("Twice = 2 * Driver Station/Trip Time"), zip.parent))
        pages.failures.shouldBeEmpty()
        additionsIn(pages.made[0]) shouldContain "Twice = 2 * Driver Station/Trip Time"
        Files.readString(pages.made[1]) shouldContain "class=\"compared\" data-name=\"match.zip.wpilog\""
    }

    test("a ZIP without logs is refused in a sentence") {
        val zip = tempdir().toPath().resolve("a.zip")
        ZipOutputStream(Files.newOutputStream(zip)).use { it.putNextEntry(ZipEntry("a.txt")) }
        shouldThrow<NotReadException> { OpenRecording.read(zip) }.message.orEmpty() shouldContain "archive"
    }
})
