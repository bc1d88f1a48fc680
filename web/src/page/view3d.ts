// The gimbal in three dimensions: frame, three arms and camera. It is loaded when it is wanted.
//
// Camera and frame stand as the board says. The arms between them turn as far as that takes, which
// is what the board reports as its joints while the frame is level.

import * as THREE from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";

import type { Axes } from "../worker_messages.js";
import { radians, type Direction } from "./axes.js";
import { colorsOf } from "./theme.js";

/** In three.js, x is right, y up, and -z forward: all angles of the board turn the other way. */
const order = "YZX";
const attitude = ([roll, pitch, yaw]: Axes): THREE.Quaternion =>
  new THREE.Quaternion().setFromEuler(
    new THREE.Euler(-radians(pitch), -radians(yaw), -radians(roll), order),
  );

export interface View3D {
  show(frame: Axes, camera: Axes): void;
  resize(): void;
  recolor(): void;
  /** Where the lens points in the world, as the scene has it. */
  opticalAxis(): Direction;
  /** Turns the viewer around the gimbal, by radians. */
  orbit(around: number, up: number): void;
  end(): void;
}

/** A material that software can draw as well. */
const paint = (specular: number, color = 0xffffff) =>
  new THREE.MeshPhongMaterial({ color, specular, shininess: 40 });

function createGimbal() {
  const materials = {
    frame: paint(0x222222),
    arm: paint(0x444444),
    body: paint(0x333333),
    glass: paint(0xaaccee, 0x0b1622),
    roll: paint(0x333333),
    pitch: paint(0x333333),
    yaw: paint(0x333333),
    beam: new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.16, depthWrite: false }),
  };
  type Vector = [number, number, number];
  const add = (group: THREE.Group, geometry: THREE.BufferGeometry, material: THREE.Material) =>
    group.add(new THREE.Mesh(geometry, material));
  const box = (group: THREE.Group, name: keyof typeof materials, size: Vector, at: Vector) => {
    const geometry = new RoundedBoxGeometry(...size, 3, Math.min(...size) * 0.35);
    add(group, geometry.translate(...at), materials[name]);
  };
  const rod = (
    group: THREE.Group,
    name: keyof typeof materials,
    [radius, length]: [number, number],
    at: Vector,
    along: "x" | "y" | "z" = "y",
  ) => {
    const geometry = new THREE.CylinderGeometry(radius, radius, length, 40);
    if (along === "x") geometry.rotateZ(Math.PI / 2);
    if (along === "z") geometry.rotateX(Math.PI / 2);
    add(group, geometry.translate(...at), materials[name]);
  };

  // All axes meet in the camera, at the origin.
  const frame = new THREE.Group();
  box(frame, "frame", [2.6, 0.12, 0.2], [0, 1.72, 0]);
  rod(frame, "body", [0.11, 0.75], [-1.32, 1.72, 0]);
  rod(frame, "body", [0.11, 0.75], [1.32, 1.72, 0]);
  box(frame, "frame", [0.34, 0.16, 0.62], [0, 1.75, 0]);
  box(frame, "yaw", [0.08, 0.05, 0.4], [0, 1.85, -0.18]);
  const yawArm = new THREE.Group();
  rod(yawArm, "yaw", [0.2, 0.24], [0, 1.52, 0]);
  box(yawArm, "arm", [0.16, 0.1, 1.12], [0, 1.36, 0.46]);
  box(yawArm, "arm", [0.16, 1.46, 0.1], [0, 0.68, 0.98]);
  rod(yawArm, "roll", [0.19, 0.22], [0, 0, 0.9], "z");
  const rollArm = new THREE.Group();
  box(rollArm, "arm", [0.92, 0.15, 0.1], [0.4, 0, 0.76]);
  box(rollArm, "arm", [0.1, 0.15, 0.86], [0.82, 0, 0.38]);
  rod(rollArm, "pitch", [0.18, 0.2], [0.72, 0, 0], "x");
  const camera = new THREE.Group();
  box(camera, "body", [1.05, 0.7, 0.5], [0, 0, 0.02]);
  box(camera, "body", [0.4, 0.16, 0.3], [0, 0.4, 0.02]);
  rod(camera, "arm", [0.27, 0.34], [0, 0, -0.38], "z");
  rod(camera, "body", [0.3, 0.08], [0, 0, -0.55], "z");
  rod(camera, "glass", [0.23, 0.02], [0, 0, -0.59], "z");
  rod(camera, "roll", [0.045, 0.06], [0.4, 0.37, 0.02]);
  const beam = new THREE.ConeGeometry(0.75, 2.1, 4, 1, true).rotateY(Math.PI / 4);
  add(camera, beam.rotateX(Math.PI / 2).translate(0, 0, -1.62), materials.beam);

  frame.add(yawArm);
  yawArm.add(rollArm);
  rollArm.add(camera);
  return { frame, yawArm, rollArm, camera, materials };
}

export function createView(canvas: HTMLCanvasElement, context: WebGL2RenderingContext): View3D {
  const renderer = new THREE.WebGLRenderer({ canvas, context });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  const { frame, yawArm, rollArm, camera, materials } = createGimbal();
  const sun = new THREE.DirectionalLight(0xffffff, 2.2);
  sun.position.set(3, 6, 5);
  const scene = new THREE.Scene();
  scene.add(frame, sun, new THREE.HemisphereLight(0xffffff, 0x8a8f94, 1.6));
  let grid: THREE.GridHelper | null = null;

  const viewer = new THREE.PerspectiveCamera(32, 1, 0.1, 100);
  const center = new THREE.Vector3(0, 0.3, 0);
  let azimuth = 0.65;
  let elevation = 0.32;
  const compilesAside = context.getExtension("KHR_parallel_shader_compile") !== null;
  let isCompiled = !compilesAside;
  const render = (): void => {
    if (!isCompiled) return;
    const distance = viewer.aspect < 1.2 ? 9.4 : 7.4;
    viewer.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth).add(center);
    viewer.lookAt(center);
    renderer.render(scene, viewer);
  };

  // The attitudes of the last picture. Noise that moves nothing by a pixel costs none.
  const drawn = { frame: new THREE.Quaternion(), camera: new THREE.Quaternion() };
  const leastVisible = radians(0.05);

  const view: View3D = {
    show: (frameAngles, cameraAngles) => {
      frame.quaternion.copy(attitude(frameAngles));
      const seen = attitude(cameraAngles);
      const relative = frame.quaternion.clone().invert().multiply(seen);
      const joints = new THREE.Euler().setFromQuaternion(relative, order);
      yawArm.rotation.y = joints.y;
      rollArm.rotation.z = joints.z;
      camera.rotation.x = joints.x;
      const turned = Math.max(drawn.frame.angleTo(frame.quaternion), drawn.camera.angleTo(seen));
      if (turned < leastVisible) return;
      drawn.frame.copy(frame.quaternion);
      drawn.camera.copy(seen);
      render();
    },
    resize: () => {
      const { clientWidth, clientHeight } = canvas;
      if (!clientWidth || !clientHeight) return;
      renderer.setSize(clientWidth, clientHeight, false);
      viewer.aspect = clientWidth / clientHeight;
      viewer.updateProjectionMatrix();
      render();
    },
    recolor: () => {
      const color = colorsOf(canvas);
      const isDark = color("color-scheme").includes("dark");
      materials.roll.color.set(color("--edge-5"));
      materials.pitch.color.set(color("--edge-2"));
      materials.yaw.color.set(color("--edge-0"));
      materials.beam.color.set(color("--accent"));
      materials.frame.color.set(isDark ? 0x8d97a3 : 0x6b747d);
      materials.arm.color.set(isDark ? 0xb4bcc6 : 0xa3abb3);
      materials.body.color.set(isDark ? 0x4a535e : 0x343b42);
      if (grid) scene.remove(grid);
      grid?.dispose();
      grid = new THREE.GridHelper(14, 14, color("--line-strong"), color("--line"));
      grid.position.y = -1.55;
      scene.add(grid);
      render();
    },
    opticalAxis: () => {
      const turned = camera.getWorldQuaternion(new THREE.Quaternion());
      const { x, y, z } = new THREE.Vector3(0, 0, -1).applyQuaternion(turned);
      return [x, y, -z];
    },
    orbit: (around, up) => {
      azimuth -= around;
      elevation = Math.max(-0.15, Math.min(1.4, elevation + up));
      render();
    },
    end: () => renderer.dispose(),
  };
  view.recolor();
  view.resize();
  const compiled = (): void => {
    isCompiled = true;
    render();
  };
  if (compilesAside) void renderer.compileAsync(scene, viewer).then(compiled);
  return view;
}
