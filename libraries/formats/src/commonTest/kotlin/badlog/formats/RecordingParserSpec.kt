package badlog.formats

import badlog.core.bag.RecordingParser
import badlog.core.bag.VARIED_BAG
import badlog.core.bag.describe
import badlog.core.bag.parse
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.parseLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun read(bytes: ByteArray, piece: Int): RecordingParser {
    val parser = RecordingParser(LOG_FORMATS, bytes.size.toLong())
    for (at in bytes.indices step piece) parser.accept(bytes, at, minOf(at + piece, bytes.size))
    return parser
}

class RecordingParserSpec : FunSpec({
    test("bags and WPILOGs are recognized by their first bytes, in pieces of any size") {
        for (piece in listOf(1, 4, 100_000)) {
            describe(read(VARIED_BAG.encodeToByteArray(), piece).finish()) shouldBe describe(parse(VARIED_BAG))
            describeLog(read(VARIED_LOG.bytes, piece).finish()) shouldBe describeLog(parseLog(VARIED_LOG.bytes))
        }
    }

    test("files of a few bytes, and empty ones, are read as bags") {
        for (text in listOf("", "a\n", "a\n1\n", "WPILO")) {
            describe(read(text.encodeToByteArray(), 1).finish()) shouldBe describe(parse(text))
        }
    }

    test("counts rows and records") {
        read("a,b\n1,2\n3,4\n".encodeToByteArray(), 3).apply { finish() }.rowCount shouldBe 2
        read(VARIED_LOG.bytes, 3).apply { finish() }.rowCount shouldBe 30
    }
})
