// The gimbal in three dimensions: frame, three arms and camera. It is loaded when it is wanted.
//
// Camera and frame stand as the board says. The arms between them turn as far as that takes, which
// is what the board reports as its joints while the frame is level.

import {
  Color,
  CylinderGeometry,
  DirectionalLight,
  Euler,
  GridHelper,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  ConeGeometry,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
  type BufferGeometry,
  type Material,
  type Object3D,
} from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";

import type { Axes } from "../worker_messages.js";
import { radians, type Direction } from "./attitude.js";

/** In three.js, x is right, y up, and -z forward: all three angles of the board turn the other way. */
const order = "YZX";
const attitude = ([roll, pitch, yaw]: Axes): Quaternion =>
  new Quaternion().setFromEuler(
    new Euler(-radians(pitch), -radians(yaw), -radians(roll), order),
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

export function createView(canvas: HTMLCanvasElement): View3D {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  const scene = new Scene();
  const viewer = new PerspectiveCamera(32, 1, 0.1, 100);
  const center = new Vector3(0, 0.3, 0);
  let azimuth = 0.65;
  let elevation = 0.32;

  const materials = {
    frame: new MeshStandardMaterial({ roughness: 0.7 }),
    arm: new MeshStandardMaterial({ roughness: 0.55 }),
    body: new MeshStandardMaterial({ roughness: 0.5 }),
    glass: new MeshStandardMaterial({ color: 0x0b1622, roughness: 0.08, metalness: 0.4 }),
    roll: new MeshStandardMaterial({ roughness: 0.45 }),
    pitch: new MeshStandardMaterial({ roughness: 0.45 }),
    yaw: new MeshStandardMaterial({ roughness: 0.45 }),
    beam: new MeshBasicMaterial({ transparent: true, opacity: 0.16, depthWrite: false }),
  };

  const part = (
    parent: Object3D,
    geometry: BufferGeometry,
    material: Material,
    at: [number, number, number],
    turned: [number, number, number] = [0, 0, 0],
  ): Mesh => {
    const mesh = new Mesh(geometry, material);
    mesh.position.set(...at);
    mesh.rotation.set(...turned);
    parent.add(mesh);
    return mesh;
  };
  const box = (x: number, y: number, z: number): BufferGeometry =>
    new RoundedBoxGeometry(x, y, z, 3, Math.min(x, y, z) * 0.35);
  const rod = (radius: number, length: number): BufferGeometry =>
    new CylinderGeometry(radius, radius, length, 40);
  const side = Math.PI / 2;

  // All axes meet in the camera, at the origin.
  const frame = new Group();
  part(frame, box(2.6, 0.12, 0.2), materials.frame, [0, 1.72, 0]);
  part(frame, rod(0.11, 0.75), materials.body, [-1.32, 1.72, 0]);
  part(frame, rod(0.11, 0.75), materials.body, [1.32, 1.72, 0]);
  part(frame, box(0.34, 0.16, 0.62), materials.frame, [0, 1.75, 0]);
  part(frame, box(0.08, 0.05, 0.4), materials.yaw, [0, 1.85, -0.18]);

  const yawArm = new Group();
  part(yawArm, rod(0.2, 0.24), materials.yaw, [0, 1.52, 0]);
  part(yawArm, box(0.16, 0.1, 1.12), materials.arm, [0, 1.36, 0.46]);
  part(yawArm, box(0.16, 1.46, 0.1), materials.arm, [0, 0.68, 0.98]);
  part(yawArm, rod(0.19, 0.22), materials.roll, [0, 0, 0.9], [side, 0, 0]);

  const rollArm = new Group();
  part(rollArm, box(0.92, 0.15, 0.1), materials.arm, [0.4, 0, 0.76]);
  part(rollArm, box(0.1, 0.15, 0.86), materials.arm, [0.82, 0, 0.38]);
  part(rollArm, rod(0.18, 0.2), materials.pitch, [0.72, 0, 0], [0, 0, side]);

  const camera = new Group();
  part(camera, box(1.05, 0.7, 0.5), materials.body, [0, 0, 0.02]);
  part(camera, box(0.4, 0.16, 0.3), materials.body, [0, 0.4, 0.02]);
  part(camera, rod(0.27, 0.34), materials.arm, [0, 0, -0.38], [side, 0, 0]);
  part(camera, rod(0.3, 0.08), materials.body, [0, 0, -0.55], [side, 0, 0]);
  part(camera, rod(0.23, 0.02), materials.glass, [0, 0, -0.59], [side, 0, 0]);
  part(camera, rod(0.045, 0.06), materials.roll, [0.4, 0.37, 0.02]);
  const beam = new ConeGeometry(0.75, 2.1, 4, 1, true).rotateY(Math.PI / 4);
  part(camera, beam, materials.beam, [0, 0, -1.62], [side, 0, 0]);

  rollArm.add(camera);
  yawArm.add(rollArm);
  frame.add(yawArm);
  scene.add(frame);

  const sky = new HemisphereLight(0xffffff, 0x8a8f94, 1.6);
  const sun = new DirectionalLight(0xffffff, 2.2);
  sun.position.set(3, 6, 5);
  scene.add(sky, sun);
  let grid: GridHelper | null = null;

  const render = (): void => renderer.render(scene, viewer);

  const look = (): void => {
    const distance = viewer.aspect < 1.2 ? 9.4 : 7.4;
    viewer.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth);
    viewer.position.add(center);
    viewer.lookAt(center);
  };

  const show = (frameAngles: Axes, cameraAngles: Axes): void => {
    frame.quaternion.copy(attitude(frameAngles));
    const relative = frame.quaternion.clone().invert().multiply(attitude(cameraAngles));
    const joints = new Euler().setFromQuaternion(relative, order);
    yawArm.rotation.y = joints.y;
    rollArm.rotation.z = joints.z;
    camera.rotation.x = joints.x;
    render();
  };

  const resize = (): void => {
    const { clientWidth, clientHeight } = canvas;
    if (!clientWidth || !clientHeight) return;
    renderer.setSize(clientWidth, clientHeight, false);
    viewer.aspect = clientWidth / clientHeight;
    viewer.updateProjectionMatrix();
    look();
    render();
  };

  const recolor = (): void => {
    const style = getComputedStyle(canvas);
    const color = (name: string): Color => new Color(style.getPropertyValue(name).trim());
    const isDark = style.colorScheme.includes("dark");
    materials.roll.color = color("--edge-5");
    materials.pitch.color = color("--edge-2");
    materials.yaw.color = color("--edge-0");
    materials.beam.color = color("--accent");
    materials.frame.color = new Color(isDark ? 0x8d97a3 : 0x6b747d);
    materials.arm.color = new Color(isDark ? 0xb4bcc6 : 0xa3abb3);
    materials.body.color = new Color(isDark ? 0x4a535e : 0x343b42);
    if (grid) {
      scene.remove(grid);
      grid.dispose();
    }
    grid = new GridHelper(14, 14, color("--line-strong"), color("--line"));
    grid.position.y = -1.55;
    scene.add(grid);
    render();
  };

  recolor();
  resize();
  return {
    show,
    resize,
    recolor,
    opticalAxis: () => {
      const { x, y, z } = new Vector3(0, 0, -1).applyQuaternion(
        camera.getWorldQuaternion(new Quaternion()),
      );
      return [x, y, -z];
    },
    orbit: (around, up) => {
      azimuth -= around;
      elevation = Math.max(-0.15, Math.min(1.4, elevation + up));
      look();
      render();
    },
    end: () => renderer.dispose(),
  };
}
