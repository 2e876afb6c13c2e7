package badlog.window.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FileChoiceSpec : FunSpec({
    test("Windows, whose dialog ignores filters, is asked for a pattern of names; other systems filter, and any name needs neither") {
        patternOf(".toml", "Windows 11") shouldBe "*.toml"
        patternOf(".toml", "Linux") shouldBe null
        patternOf(".toml", "Mac OS X") shouldBe null
        patternOf("", "Windows 11") shouldBe null
    }
})
