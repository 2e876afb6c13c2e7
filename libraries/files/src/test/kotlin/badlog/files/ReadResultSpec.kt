package badlog.files

import badlog.formats.LOG_FORMATS
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.matchers.types.shouldBeSameInstanceAs
import java.io.IOException
import java.util.concurrent.CancellationException
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

class ReadResultSpec : FunSpec({
    val folder = tempdir().toPath()
    val log = folder.resolve("a.csv").apply { writeText("Time,A\n0,1\n1,2\n") }
    val other = folder.resolve("b.bag").apply { writeBytes(byteArrayOf(0x50, 0x4B, 3, 4, 0, 0, 0, 0)) }

    fun notRead(work: () -> Unit): ReadResult.NotRead = orNotRead(log, { return@notRead it }) {
        work()
        error("it was read")
    }

    test("a log is read, whole or up to its last line end") {
        readLog(log, LOG_FORMATS).orThrow().rowCount shouldBe 2
        val growing = folder.resolve("growing.csv").apply { writeText("Time,A\n0,1\n1,") }
        readLog(growing, LOG_FORMATS, ReadOptions(untilLastLineEnd = true)).orThrow().run { rowCount to problems.size } shouldBe (1 to 0)
    }

    test("a file that is not a log stays so until it changes, and its sentence names it once") {
        val read = readLog(other, LOG_FORMATS).shouldBeInstanceOf<ReadResult.NotRead>()
        read.cause shouldBe ReadResult.Cause.NO_LOG
        read.isLasting shouldBe true
        read.sentence shouldBe "$other: ${read.message}"
        shouldThrow<NotReadException> { read.orThrow() }.run {
            message shouldBe read.sentence
            file shouldBe other
            why shouldBeSameInstanceAs read
        }
    }

    test("a missing file may come back, and its sentence names it once") {
        val missing = folder.resolve("missing.bag")
        val read = readLog(missing, LOG_FORMATS).shouldBeInstanceOf<ReadResult.NotRead>()
        read.cause shouldBe ReadResult.Cause.UNREADABLE
        read.isLasting shouldBe false
        read.sentence shouldBe read.message
        read.message shouldContain "There is no file or folder $missing"
    }

    test("a log that needs too much memory is reported alike, wherever memory ended") {
        val sentences = listOf(
            { throw TooLargeFileException(log, tooLargeSentence("$log"), OutOfMemoryError()) },
            { throw OutOfMemoryError() },
        ).map { fail -> notRead(fail).also { it.cause shouldBe ReadResult.Cause.TOO_LARGE }.sentence }
        sentences.distinct().single().run {
            this shouldStartWith "$log does not fit into the "
            this shouldContain "JAVA_TOOL_OPTIONS"
        }
    }

    test("a full disk for temporary files is not a bug, and its sentence names the log and the file that needs room") {
        val made = folder.resolve("made.wpilog")
        val read = notRead { writing(made) { throw IOException("No space left on device") } }
        read.cause shouldBe ReadResult.Cause.NO_ROOM
        read.isLasting shouldBe false
        read.sentence shouldBe "$log: $made cannot be written (No space left on device); select another place."
        shouldThrow<NotReadException> { read.orThrow() }.message shouldBe read.sentence
    }

    test("a bug is a result of one line, and is thrown unchanged") {
        val bug = IllegalStateException("odd\nand long")
        val read = notRead { throw bug }
        read.cause shouldBe ReadResult.Cause.BUG
        read.sentence shouldBe
            "$log: This is a bug in badlog (java.lang.IllegalStateException: odd); report it, with the file if you may share it."
        shouldThrow<IllegalStateException> { read.orThrow() } shouldBeSameInstanceAs bug
        bugSentence(bug) shouldEndWith "odd); report it."
        bugSentence(bug) shouldNotContain "long"
    }

    test("cancelling and interrupting are passed on") {
        shouldThrow<CancellationException> { notRead { throw CancellationException() } }
        shouldThrow<InterruptedException> { notRead { throw InterruptedException() } }
    }
})
