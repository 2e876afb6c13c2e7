package badlog.html

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

    test("the policy has the hashes of the program and of the style, as a browser reads their lines") {
        val parts = PageParts("let a\r\nlet ü\r", "b{}\n")
        parts.policy shouldContain "script-src ${hash(UNPACKING)} ${hash("let a\nlet ü\n")};"
        parts.policy shouldContain "style-src ${hash("b{}\n")};"
        parts.policy.substringBefore(';') shouldBe "default-src 'none'"
    }

    test("a style that would end its element is refused, a program stands in the page packed") {
        PageParts("a='</script><!--'", "").packedProgram.decodeToString() shouldNotContain "<"
        shouldThrow<IllegalArgumentException> { PageParts("", "a::after{content:'</Style>'}") }
    }

    test("the page of this build is fit to be embedded, and small") {
        val parts = PageParts.bundled()
        check(parts.packedProgram.size + parts.style.size < 350_000 - 4_000)
    }
})
