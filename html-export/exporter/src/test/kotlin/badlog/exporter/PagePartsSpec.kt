package badlog.exporter

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.security.MessageDigest
import java.util.Base64

class PagePartsSpec : FunSpec({
    fun hash(text: String): String {
        val digest = MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray())
        return "'sha256-${Base64.getEncoder().encodeToString(digest)}'"
    }

    test("the policy has the hashes of the program and of both styles, with line ends as browsers read them") {
        val parts = PageParts("let a\r\nlet ü\r", "b{}\r\n", "p{}\n")
        parts.policy(false) shouldContain "script-src ${hash(UNPACKING)} ${hash("let a\nlet ü\n")};"
        parts.policy(false) shouldContain "style-src ${hash("p{}\n")} ${hash("b{}\n")};"
        parts.policy(false).substringBefore(';') shouldBe "default-src 'none'"
    }

    test("only a page with a video beside it may play a video that the reader has not opened") {
        val parts = PageParts("", "")
        parts.policy(false) shouldContain "; media-src blob:;"
        parts.policy(true) shouldContain "; media-src blob: 'self';"
    }

    test("a style that would end its element is refused; a program and its style are packed in the page") {
        val style = "a::after{content:'</Style>'}"
        PageParts("a='</script><!--'", style).packedProgram.decodeToString() shouldNotContain "<"
        shouldThrow<IllegalArgumentException> { PageParts("", "", style) }
    }

    test("a style with the character that separates it from the program is refused") {
        shouldThrow<IllegalArgumentException> { PageParts("", "a{}\u0000b{}") }
    }

    test("this build contains the parts of the page") { PageParts.bundled().waitingStyle shouldContain ".waiting{" }
})
