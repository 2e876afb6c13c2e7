package badlog.viewer.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly

class ShortNamesSpec : FunSpec({
    test("a name is as short as possible while it differs from the others") {
        shortNames(listOf("Drive/Left/speed", "Drive/Right/speed", "Arm/Angle")) shouldContainExactly listOf("Left/speed", "Right/speed", "Angle")
        shortNames(listOf("A/Left/speed", "B/Left/speed")) shouldContainExactly listOf("A/Left/speed", "B/Left/speed")
        shortNames(listOf("Arm/Angle")) shouldContainExactly listOf("Angle")
    }

    test("a name that is the end of another one stays whole") {
        shortNames(listOf("speed", "Left/speed")) shouldContainExactly listOf("speed", "Left/speed")
        shortNames(listOf("NT:/speed", "/speed")) shouldContainExactly listOf("NT:/speed", "/speed")
    }

    test("slashes at the ends are not folders, and equal names are shortened equally") {
        shortNames(listOf("/Arm/", "Arm/Angle", "Arm/Angle", "")) shouldContainExactly listOf("Arm", "Angle", "Angle", "")
    }
})
