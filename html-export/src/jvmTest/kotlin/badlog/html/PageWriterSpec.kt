package badlog.html

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.ByteArrayOutputStream

class PageWriterSpec : FunSpec({
    fun begin(title: String): String {
        val out = ByteArrayOutputStream()
        PageWriter(out, PageParts("", "")).begin(title)
        return out.toString()
    }

    test("a title stands as it is between lines that it does not change") {
        val (before, after) = begin("match").split("match")
        for (title in listOf("  a", "a\nb", "\n    a\n  b\n", "\n", "", "\$1")) {
            begin(title) shouldBe before + title + after
        }
    }

    test("a page begins as the command line knows pages to begin") {
        begin("a\nb") shouldStartWith PAGE_START
        begin("a\nb") shouldContain "<title>a\nb</title>\n<style>"
    }
})
