package badlog.page.embedded

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class Base64Spec : FunSpec({
    test("every padding, and a text cut inside a group, are decoded") {
        Base64.decode("QmFk").decodeToString() shouldBe "Bad"
        Base64.decode("QmFkTA==").decodeToString() shouldBe "BadL"
        Base64.decode("QmFkTG8=").decodeToString() shouldBe "BadLo"
        Base64.decode("QmFkT").decodeToString() shouldBe "Bad"
        Base64.decode("").size shouldBe 0
    }

    test("the table agrees with the browser's decoder") {
        Base64.decodeByTable("/+8AAQI=").toList() shouldBe listOf<Byte>(-1, -17, 0, 1, 2)
        Base64.decode("/+8AAQI=").toList() shouldBe listOf<Byte>(-1, -17, 0, 1, 2)
    }
})
