package badlog.core.recording

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PathNameSpec : FunSpec({
    test("slashes make folders, except at the start and the end") {
        val names = mapOf(
            "Drivetrain/Wheels/A Position" to ("Drivetrain/Wheels" to "A Position"),
            "Time" to ("" to "Time"),
            "/Time" to ("" to "Time"),
            "/a/b" to ("a" to "b"),
            "Arm/" to ("" to "Arm/"),
            "a/b/" to ("a" to "b/"),
            "/" to ("" to "/"),
            "" to ("" to ""),
        )
        for ((name, parts) in names) (PathName.folderOf(name) to PathName.baseNameOf(name)) shouldBe parts
    }
})
