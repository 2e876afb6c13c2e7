package badlog.window.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FileChoiceSpec : FunSpec({
    test("only Windows gets a pattern of names, because its dialog ignores filters") {
        patternOf(".toml", "Windows 11") shouldBe "*.toml"
        patternOf(".toml", "Linux") shouldBe null
        patternOf(".toml", "Mac OS X") shouldBe null
        patternOf("", "Windows 11") shouldBe null
    }
})
