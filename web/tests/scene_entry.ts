// What the tests of the scene need of it, in one script.
export { decodeMesh, Topologies, TopologyMissing } from "../src/scene/frame";
export { ModelView } from "../src/scene/model_view";
