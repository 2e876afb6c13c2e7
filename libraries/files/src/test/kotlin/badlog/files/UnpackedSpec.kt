package badlog.files

import badlog.core.recording.ProblemKind
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.parseLog
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import org.tukaani.xz.LZMA2Options
import org.tukaani.xz.XZOutputStream
import java.io.ByteArrayOutputStream
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.random.Random

private fun xz(bytes: ByteArray): ByteArray {
    val out = ByteArrayOutputStream()
    XZOutputStream(out, LZMA2Options()).use { it.write(bytes) }
    return out.toByteArray()
}

/** A program that is a script for sh. */
private val IF_SHELL =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has no sh")

@Tags("InCheck")
internal class UnpackedSpec : FunSpec({
    val log = VARIED_LOG.bytes

    fun programOf(folder: Path, text: String): String {
        val program = Files.writeString(folder.resolve("owlet"), "#!/bin/sh\n$text\n")
        check(program.toFile().setExecutable(true))
        return program.toString()
    }

    test("a log compressed with xz reads as the log, whatever its name, and leaves nothing behind") {
        inFolder { folder ->
            val file = Files.write(folder.resolve("match.wpilogxz"), xz(log))
            describeLog(readRecording(file, LOG_FORMATS)) shouldBe describeLog(parseLog(log))
            lateinit var made: Path
            unpacked(file) { unpacked ->
                made = unpacked.path
                unpacked.name shouldBe "match.wpilog"
                Files.readAllBytes(made) shouldBe log
            }
            Files.exists(made) shouldBe false
        }
    }

    test("a cut or damaged xz file is read up to the damage, without an exception") {
        // Noise: data that repeats is inflated at once.
        val large = log + noise()
        val packed = xz(large)
        val file = tempdir().toPath().resolve("cut.wpilogxz")
        Files.write(file, packed.copyOf(packed.size / 2))
        val recording = readRecording(file, LOG_FORMATS)
        recording.problems.first().kind shouldBe ProblemKind.GZIP_CUT
        recording.topics.map { it.name } shouldBe parseLog(log).topics.map { it.name }
        checkAll(iterations = 50, Arb.int(packed.indices), Arb.byte()) { at, byte ->
            Files.write(file, packed.copyOf().also { it[at] = byte })
            readRecording(file, LOG_FORMATS)
        }
    }

    test("an ordinary log is not copied") {
        inFolder { folder ->
            val file = Files.write(folder.resolve("match.wpilog"), log)
            unpacked(file) { it.path to it.name } shouldBe (file to "match.wpilog")
        }
    }

    test("a hoot log is converted to a WPILOG by CTRE's program").config(enabledOrReasonIf = { IF_SHELL }) {
        inFolder { folder ->
            val made = folder.resolve("made.wpilog")
            val hoot = Files.write(folder.resolve("a b.hoot"), log)
            val program = programOf(folder, "[ \"$3 $4\" = \"-f wpilog\" ] && cp \"$1\" \"$2\"")
            Owlet.convert(hoot, made, {}, program) shouldBe emptyList()
            Files.readAllBytes(made) shouldBe log
        }
    }

    test("without CTRE's program, or if it fails, one sentence says what to do").config(enabledOrReasonIf = { IF_SHELL }) {
        inFolder { folder ->
            val made = Files.createFile(folder.resolve("made.wpilog"))
            val hoot = Files.write(folder.resolve("a.hoot"), log)
            shouldThrow<UnreadableFileException> { Owlet.convert(hoot, made, {}, folder.resolve("none").toString()) }.message shouldContain
                "a.hoot can only be read by CTRE's program owlet; AdvantageScope downloads it"
            val program = programOf(folder, "echo first; echo 'The log is too new.'; exit 1")
            shouldThrow<UnreadableFileException> { Owlet.convert(hoot, made, {}, program) }.message shouldContain "(The log is too new.); try a newer owlet"
        }
    }

    test("a hoot log is recognized by its own name while it is copied under another one") {
        inFolder { folder ->
            val part = Files.write(folder.resolve(".copy.part"), log)
            unpacked(part) { it.path } shouldBe part
            if (!Owlet.isInstalled) {
                shouldThrow<UnreadableFileException> { readRecording(part, LOG_FORMATS, ReadOptions(name = "a.hoot")) }.message shouldContain "owlet"
            }
        }
    }

    test("files that a killed program left are removed, but not files of running or other programs") {
        inFolder { folder ->
            val killed = ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-version").start()
            killed.waitFor()
            val left = listOf(Files.createFile(folder.resolve("badlog-${killed.pid()}-12.wpilog")), Files.createFile(folder.resolve("badlog-${killed.pid()}-3.txt")))
            val kept = listOf("badlog-${ProcessHandle.current().pid()}-12.wpilog", "badlog-${killed.pid()}-12.bag", "badlog-12.wpilog")
                .map { Files.createFile(folder.resolve(it)) }
            removeLeftFiles(folder)
            left.filter(Files::exists) shouldBe emptyList()
            kept.filter(Files::exists) shouldBe kept
            newMadeFile(".wpilog", folder).fileName.toString().startsWith("badlog-${ProcessHandle.current().pid()}-") shouldBe true
        }
    }

    test("folders that a killed program left are removed with their content, and no other folders") {
        inFolder { folder ->
            val killed = ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-version").start()
            killed.waitFor()
            fun madeOf(name: String): Path = Files.createDirectories(folder.resolve(name).resolve("0")).also { Files.write(it.resolve("a.wpilog"), log) }.parent
            val left = madeOf("badlog-${killed.pid()}-1234567890.match")
            val names = listOf("badlog-${killed.pid()}-12", "badlog-${killed.pid()}-1234567890", "badlog-${killed.pid()}-12.match", "badlog-${killed.pid()}-12.wpilog", "badlog-2025-2026")
            val kept = (names + "badlog-${ProcessHandle.current().pid()}-1234567890.match").map(::madeOf)
            removeLeftFiles(folder)
            Files.exists(left) shouldBe false
            kept.filter { Files.exists(it.resolve("0").resolve("a.wpilog")) } shouldBe kept
        }
        inMadeFolder { made ->
            made.fileName.toString() shouldMatch "badlog-${ProcessHandle.current().pid()}-\\d{10}\\.match"
            made.also { Files.write(it.resolve("a.wpilog"), log) }
        }.let { Files.exists(it) } shouldBe false
    }

    test("a conversion that is canceled ends").config(enabledOrReasonIf = { IF_SHELL }) {
        inFolder { folder ->
            val made = Files.createFile(folder.resolve("made.wpilog"))
            val hoot = Files.write(folder.resolve("a.hoot"), log)
            val program = programOf(folder, "sleep 600")
            shouldThrow<IllegalStateException> { Owlet.convert(hoot, made, { error("given up") }, program) }.message shouldBe "given up"
        }
    }

    test("a folder lists only logs that can be read here") {
        inFolder { folder ->
            for (name in listOf("a.wpilogxz", "b.revlog", "c.WPILOG", "d.xz", "e.hoot")) Files.write(folder.resolve(name), log)
            val wanted = listOf("a.wpilogxz", "b.revlog", "c.WPILOG") + if (Owlet.isInstalled) listOf("e.hoot") else emptyList()
            FolderScan.of(folder).files.map { it.name } shouldContainExactlyInAnyOrder wanted
        }
    }
})

/** Records of an entry that was never started, hard to compress. */
private fun noise(): ByteArray = TestLog().let { log ->
    val random = Random(1)
    repeat(2000) { log.record(77, 1_000_000L + it, random.nextBytes(200)) }
    log.bytes.copyOfRange(12, log.bytes.size)
}
