package badlog.exporter

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

internal class PackedProgramSpec : FunSpec({
    test("a packed text unpacks to itself, and cannot end its element") {
        checkAll(Arb.string(0..300)) { text ->
            val packed = packed("a{}\u0000let ü = '</script>'$text").decodeToString()
            packed shouldMatch Regex("[A-Za-z0-9+/]*=*")
            unpacked(packed) shouldBe "a{}\u0000let ü = '</script>'$text"
        }
    }
})
