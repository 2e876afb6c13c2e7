package badlog.exporter

import badlog.files.gzip
import badlog.signals.vocabulary.SignalVocabulary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class FileHeadSpec : FunSpec({
    fun refusal(bytes: ByteArray) = FileHead.of(bytes).refusal

    test("bytes that are not text, and a WPILOG of another version, are refused at once") {
        val binary = byteArrayOf(1, 2, 3, 0, -1)
        for (bytes in listOf(binary, gzip(binary))) refusal(bytes).orEmpty() shouldContain "bytes that never occur in text"
        refusal("WPILOG\u0000\u0002\u0000\u0000\u0000\u0000".encodeToByteArray()).orEmpty() shouldContain "WPILOG of version 2"
        refusal("WPILOG\u0000\u0001\u0000\u0000\u0000\u0000".encodeToByteArray()).shouldBeNull()
    }

    test("a text without numbers so far is not refused, because numbers may follow") {
        val text = "Note\nready\n".encodeToByteArray()
        for (bytes in listOf(text, gzip(text))) refusal(bytes).shouldBeNull()
    }

    test("a header is read for the page's title") {
        FileHead.of(gzip(BAG.encodeToByteArray())).run {
            isGzip shouldBe true
            titleIn("practice-3.bag", SignalVocabulary.NONE) shouldBe "OHCL Match 42"
            refusal.shouldBeNull()
        }
    }
})
