package badlog.cli

import badlog.cli.command.ExitCode
import badlog.core.recording.ProblemKind
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlinx.serialization.json.jsonPrimitive
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.random.Random

/** Symbolic links: on Windows only administrators make them. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

/** Permissions of owner, group and others. */
private val IF_POSIX =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has other permissions")

/** What every sub-command does with files that are not whole logs. */
@Tags("InCheck")
class BrokenFilesSpec : FunSpec({
    fun each(folder: Path, log: Path, check: (List<Any>) -> Unit) {
        val other = folder.with("other.bag", BAG)
        val commands = listOf(
            listOf("info", log),
            listOf("recover", log, "-o", folder / "out/"),
            listOf("convert", log, "--to", "csv", "-o", folder / "out.csv"),
            listOf("cut", log, "--from", "0", "-o", folder / "out.bag"),
            listOf("export", log, "-o", folder / "out.html"),
        )
        commands.forEach(check)
        Files.delete(other)
    }

    fun status(ended: Ended) = ended.json.map { it.getValue("status").jsonPrimitive.content }

    test("a missing file, a file that is not a log and a folder without logs are reported in one sentence") {
        inFolder { folder ->
            val nothing = listOf(
                folder.with("random.bag", Random(1).nextBytes(5000)),
                folder.with("prose.csv", "There is nothing here\nbut words\n"),
                folder / "missing.bag",
                Files.createDirectories(folder / "none/deeper"),
            )
            for (log in nothing) {
                each(folder, log) { arguments ->
                    val ended = badlog(*arguments.toTypedArray())
                    ended.code shouldBe ExitCode.NOTHING
                    ended.err.lines().size shouldBe 2
                    val json = badlogJson(*arguments.toTypedArray())
                    json.code shouldBe ExitCode.NOTHING
                }
            }
            folder.names() shouldContainExactly listOf("none", "prose.csv", "random.bag")
        }
    }

    test("info reports an empty file as damaged, and recover and cut write no file") {
        inFolder { folder ->
            val empty = folder.with("empty.bag", "")
            badlog("info", empty).code shouldBe ExitCode.SALVAGED
            badlog("recover", empty).code shouldBe ExitCode.NOTHING
            badlog("cut", empty, "--from", "0").code shouldBe ExitCode.NOTHING
        }
    }

    test("a cut log is salvaged, with exit code 3") {
        inFolder { folder ->
            val gz = gzip(BAG.repeat(1) + "0.1,6,false,x\n".repeat(10_000))
            for (log in listOf(folder.with("cut.bag", CUT_BAG), folder.with("cut.bag.gz", gz.copyOf(gz.size / 2)))) {
                each(folder, log) { arguments ->
                    val ended = badlogJson(*arguments.toTypedArray(), *(if (arguments[0] == "info") arrayOf() else arrayOf("--force")))
                    ended.code shouldBe ExitCode.SALVAGED
                    status(ended) shouldContainExactly listOf("salvaged")
                }
            }
        }
    }

    test("results from any damaged WPILOG are whole") {
        val whole = wpilogBytes(
            listOf(
                Logged("Speed", "double", "{\"unit\":\"m/s\"}", List(40) { it / 50.0 to it * 1.25 }),
                Logged("DS:enabled", "boolean", "", listOf(0.1 to false, 0.2 to true, 0.5 to false)),
                Logged("Mode", "string", "", List(20) { it / 20.0 to "mode ${it % 3}" }),
            ),
        )
        inFolder { folder ->
            val good = folder.with("good.wpilog", whole)
            checkAll(100, Arb.int(12, whole.size), Arb.byteArray(Arb.int(0, 12), Arb.byte())) { at, noise ->
                val bytes = whole.copyOf(at) + noise + whole.copyOfRange(minOf(whole.size, at + noise.size / 2), whole.size)
                val log = folder.with("log.wpilog", if (noise.size % 3 == 0) bytes.copyOf(at) else bytes)
                val out = folder / "out.wpilog"
                for (command in listOf(
                    listOf("convert", log, "-o", out),
                    listOf("convert", log, "--rows-at", "Mode", "-o", folder / "out.bag"),
                    listOf("cut", log, "--enabled", "-o", out),
                    listOf("cut", log, "--around", "mode 1", "--before", "0", "-o", out),
                    listOf("merge", log, good, "--append", "-o", out),
                )) {
                    val ended = badlog(*command.toTypedArray(), "--force")
                    if (ended.code == ExitCode.NOTHING) continue
                    val written = readRecording(Path.of(command.last().toString()), LOG_FORMATS)
                    // A lone record that is left of a log may have a wrong time. Only the records of another log show it.
                    written.copy(problems = written.problems.filter { it.kind != ProblemKind.WILD_TIMES }).isSalvaged shouldBe false
                }
            }
        }
    }

    test("other files in a folder are skipped, and a failing file does not affect the others") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            folder.with("sub/b.csv", "Time,x\n0,1\n")
            folder.with("sub/photo.gz", Random(2).nextBytes(100))
            folder.with("sub/deep/c.badbag", CUT_BAG)
            folder.with("notes.txt", "hello")
            folder.with(".hidden/d.bag", BAG)
            val ended = badlogJson("info", folder, folder / "missing.bag")
            ended.code shouldBe ExitCode.SALVAGED
            status(ended) shouldContainExactly listOf("whole", "whole", "salvaged", "skipped", "failed")
            badlog("info", folder).err shouldBe
                "Skipped ${folder / "sub/photo.gz"}: This file is not a log that badlog can read: it has bytes that never occur in text.\n" +
                "3 logs: 2 complete, 1 incomplete.\n"
        }
    }

    test("a folder that leads back to itself is looked into once").config(enabledOrReasonIf = { IF_LINKS }) {
        inFolder { folder ->
            folder.with("sub/a.bag", BAG)
            Files.createSymbolicLink(folder / "sub/back", folder)
            badlogJson("info", folder).json.size shouldBe 1
        }
    }

    test("a folder or file without permission is reported, and the rest is done").config(enabledOrReasonIf = { IF_POSIX }) {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val locked = folder.with("locked/b.bag", BAG).parent
            Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"))
            try {
                // The administrator may look anywhere.
                if (!Files.isReadable(locked)) {
                    val ended = badlog("info", folder)
                    ended.code shouldBe ExitCode.SALVAGED
                    ended.err shouldContain "$locked cannot be read: permission denied; change its permissions, or ask its owner."
                }
            } finally {
                Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("rwxr-xr-x"))
            }
        }
    }

    test("no command replaces its input, even with --force, or another file without it") {
        inFolder { folder ->
            val log = folder.with("a.bag", CUT_BAG)
            val before = log.readBytes().toList()
            each(folder, log) { arguments ->
                if (arguments[0] == "info") return@each
                val onto = arguments.dropLast(1).toTypedArray()
                val ended = badlog(*onto, log, "--force")
                ended.code shouldBe ExitCode.NOTHING
                ended.err shouldContain "would overwrite a file that is read; name another place with --out."
                val target = folder.with("there", "old")
                badlog(*onto, target).err shouldContain "exists already; use --force to replace it, or name another place with --out."
                target.readBytes().decodeToString() shouldBe "old"
                badlog(*onto, target, "--force").code shouldBe ExitCode.SALVAGED
                Files.delete(target)
                log.readBytes().toList() shouldBe before
            }
            folder.names() shouldContainExactly listOf("a.bag")
        }
    }
})
