package badlog.files

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

@Tags("InCheck")
class FolderLockSpec : FunSpec({
    fun counted(folder: Path) = Files.readString(folder.resolve("count")).toInt()

    test("threads that count in one file lose nothing") {
        val folder = tempdir().toPath()
        List(4) { thread { countIn(folder, 100) } }.forEach { it.join() }
        counted(folder) shouldBe 400
    }

    test("programs that count in one file at the same time lose nothing") {
        val folder = tempdir().toPath()
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val command = listOf(java, "-cp", System.getProperty("java.class.path"), "badlog.files.CountingProgramKt", "$folder", "100")
        val programs = List(3) { ProcessBuilder(command).redirectErrorStream(true).start() }
        for (program in programs) program.inputStream.read()
        for (program in programs) program.outputStream.close()
        for (program in programs) {
            program.waitFor(1, TimeUnit.MINUTES) shouldBe true
            program.exitValue() shouldBe 0
        }
        counted(folder) shouldBe 300
    }

    test("if no lock can be taken, the work is done without one") {
        val folder = tempdir().toPath()
        Files.createDirectories(folder.resolve(".badlog.lock"))
        countIn(folder, 3)
        counted(folder) shouldBe 3
        locking(Files.writeString(folder.resolve("no folder"), "")) { 4 } shouldBe 4
    }

    test("a program that keeps the lock does not block the work of others") {
        val folder = tempdir().toPath()
        FileChannel.open(folder.resolve(".badlog.lock"), CREATE, WRITE).use {
            it.lock()
            countIn(folder, 1)
        }
        counted(folder) shouldBe 1
    }
})
